#include "BulletHybridFiles/btHybridModel.h"

#include <scatter/io/model_file.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bullet/shapes/conversions.h"
#include "bullet/shapes/part_shapes.h"

struct btHybridModelContent
{
	std::string m_mistake;
	std::string m_name;
	std::vector<std::string> m_warnings;
	scatter::PartShapes m_shapes;
	btHybridLevelSet m_levels;
	btTransform m_centerOfMass = btTransform::getIdentity();
	btVector3 m_localInertia = btVector3(0, 0, 0);
	btScalar m_mass = 0;
	btScalar m_friction = btScalar(0.5);
	btScalar m_restitution = 0;

	// What it returns says what Bullet cannot have.
	const char* take(const scatter::FileModel& file);
};

const char* btHybridModelContent::take(const scatter::FileModel& file)
{
	const scatter::Model& model = file.model;
	const scatter::MassFrame frame = scatter::massFrame(model.levels->mass());
	const char* mistake = m_shapes.addLevels(*model.levels, frame.center, m_levels);
	if (mistake != nullptr)
		return mistake;
	const bool isDynamic = file.motion == scatter::DocumentMotion::kDynamic;
	m_name = model.name;
	m_warnings = file.warnings;
	m_centerOfMass = scatter::toBullet(frame.center);
	m_mass = isDynamic ? model.mass : btScalar(0);
	m_localInertia = scatter::toBullet(frame.inertia * m_mass);
	m_friction = model.friction;
	m_restitution = model.restitution;
	return nullptr;
}

btHybridModel::btHybridModel() : m_content(new btHybridModelContent)
{
}

btHybridModel::~btHybridModel()
{
	delete m_content;
}

const char* btHybridModel::load(const char* fileName, const char* bodyName)
{
	std::string& mistake = m_content->m_mistake;
	if (m_content->m_levels.getNumLevels() > 0)
		mistake = "this model is \"" + m_content->m_name + "\" already; load another file into another btHybridModel";
	else if (fileName == nullptr)
		mistake = "there is no file name; give that of a .dae, .gltf or .glb file";
	else
		mistake.clear();
	if (!mistake.empty())
		return mistake.c_str();

	const scatter::Result<scatter::FileModel> file =
	    scatter::readModelFile(fileName, bodyName != nullptr ? bodyName : "");
	if (!file)
	{
		mistake = file.error().message;
		return mistake.c_str();
	}
	auto content = std::make_unique<btHybridModelContent>();
	if (const char* refused = content->take(*file))
	{
		mistake = std::string(fileName) + ": " + refused;
		return mistake.c_str();
	}
	delete std::exchange(m_content, content.release());
	return nullptr;
}

const char* btHybridModel::getName() const
{
	return m_content->m_name.c_str();
}

const btHybridLevelSet& btHybridModel::getLevels() const
{
	return m_content->m_levels;
}

btScalar btHybridModel::getMass() const
{
	return m_content->m_mass;
}

const btVector3& btHybridModel::getLocalInertia() const
{
	return m_content->m_localInertia;
}

const btTransform& btHybridModel::getCenterOfMass() const
{
	return m_content->m_centerOfMass;
}

btScalar btHybridModel::getFriction() const
{
	return m_content->m_friction;
}

btScalar btHybridModel::getRestitution() const
{
	return m_content->m_restitution;
}

btTransform btHybridModel::toBodyTransform(const btTransform& modelTransform) const
{
	return modelTransform * m_content->m_centerOfMass;
}

btTransform btHybridModel::toModelTransform(const btTransform& bodyTransform) const
{
	return bodyTransform * m_content->m_centerOfMass.inverse();
}

btRigidBody::btRigidBodyConstructionInfo btHybridModel::getConstructionInfo(const btTransform& modelTransform) const
{
	const btHybridLevelSet& levels = m_content->m_levels;
	btCollisionShape* finest = levels.getLevelShape(levels.getNumLevels());
	btRigidBody::btRigidBodyConstructionInfo info(getMass(), nullptr, finest, getLocalInertia());
	info.m_startWorldTransform = toBodyTransform(modelTransform);
	info.m_friction = getFriction();
	info.m_restitution = getRestitution();
	return info;
}

int btHybridModel::getNumWarnings() const
{
	return static_cast<int>(m_content->m_warnings.size());
}

const char* btHybridModel::getWarning(int index) const
{
	if (index < 0 || index >= getNumWarnings())
		return nullptr;
	return m_content->m_warnings[static_cast<std::size_t>(index)].c_str();
}
