#include "io/collada/samples.h"

#include <gtest/gtest.h>
#include <scatter/io/collada.h>

#include <glm/geometric.hpp>

#include "io/documents.h"

namespace scatter::test {
namespace {

const std::string kCube = "-1 -1 -1 1 -1 -1 -1 1 -1 1 1 -1 -1 -1 1 1 -1 1 -1 1 1 1 1 1";

/// The Maya plug-ins: centimetres, hollow shapes without a mass, hull references without '#', scaled nodes,
/// orders of libraries at will, polygons with one <p> each, models that lead back to each other.
std::string mayaSample() {
  const std::string polygons =
      "<polygons material=\"lambert1\" count=\"2\"><input semantic=\"VERTEX\" source=\"#cube-v\" "
      "offset=\"0\"/><input semantic=\"NORMAL\" source=\"#cube-p\" offset=\"1\"/>"
      "<p>0 0 2 1 3 2 1 3</p><p>4 0 5 1 7 2 6 3</p></polygons>";
  return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.0">
  <asset><contributor><authoring_tool>Maya 7.0 | ColladaMaya v0.89</authoring_tool></contributor>
    <unit name="centimeter" meter="0.010000"/><up_axis>Y_UP</up_axis></asset>
  <library_physics_scenes>
    <physics_scene id="MayaNativePhysicsScene">
      <instance_physics_model url="#outer">
        <instance_rigid_body target="#boxNode" body="boxBody">
          <technique_common><velocity>-10.000000 0 0</velocity></technique_common>
        </instance_rigid_body>
      </instance_physics_model>
      <technique_common><gravity>0 -981 0</gravity><time_step>0.030000</time_step></technique_common>
    </physics_scene>
  </library_physics_scenes>
  <library_physics_models>
    <physics_model id="outer">
      <rigid_body name="boxBody" sid="boxBody"><technique_common>
        <dynamic sid="boxBody2">1</dynamic>
        <instance_physics_material url="#rubber"/>
        <shape><hollow>true</hollow><mass>1</mass><instance_geometry url="#cube-convex"/></shape>
      </technique_common><extra><technique profile="MAYA"><density short_name="density"/></technique></extra>
      </rigid_body>
      <instance_physics_model url="#inner">
        <instance_rigid_body target="#groundNode" body="groundBody"><technique_common/></instance_rigid_body>
      </instance_physics_model>
    </physics_model>
    <physics_model id="inner">
      <rigid_body name="groundBody" sid="groundBody"><technique_common>
        <dynamic>0</dynamic>
        <shape><hollow>false</hollow><instance_geometry url="#cube-convex"/></shape>
      </technique_common></rigid_body>
      <instance_physics_model url="#outer">
        <instance_rigid_body target="#boxNode" body="boxBody"><technique_common/></instance_rigid_body>
      </instance_physics_model>
    </physics_model>
  </library_physics_models>
  <library_physics_materials>
    <physics_material id="rubber"><technique_common><dynamic_friction>0.2</dynamic_friction>
      <restitution>0.6</restitution><static_friction>0.3</static_friction></technique_common></physics_material>
  </library_physics_materials>
  <library_geometries>)" +
         geometry("cube", "mesh", 8, kCube, polygons) + R"(
    <geometry id="cube-convex"><convex_mesh convex_hull_of="cube"/></geometry>
  </library_geometries>
  <library_visual_scenes><visual_scene id="scene">
    <node id="boxNode" name="box"><translate sid="translate">0 540.5 0</translate>
      <rotate sid="jointOrientZ">0 0 1 0</rotate><rotate sid="jointOrientY">0 1 0 90</rotate>
      <instance_geometry url="#cube"/></node>
    <node id="groundNode" name="ground"><translate>0 -50 0</translate><scale>2500 100 2500</scale>
      <instance_geometry url="#cube"/></node>
  </visual_scene></library_visual_scenes>
  <scene><instance_physics_scene url="#MayaNativePhysicsScene"/><instance_visual_scene url="#scene"/></scene>
</COLLADA>
)";
}

/// Blender's scripts: z up, rigid bodies without sid, instances without body, mass after the shapes,
/// flat boxes, a misspelt element.
std::string blenderSample() {
  return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA version="1.4.0" xmlns="http://www.collada.org/2005/11/COLLADASchema">
	<asset><contributor><authoring_tool>Blender v:242 - Illusoft Collada Exporter v:0.2.65</authoring_tool>
		</contributor><unit meter="1" name="meter"/><up_axis>Z_UP</up_axis></asset>
	<library_physics_materials>
		<physics_material id="ball-PxMaterial" name="ball-PxMaterial"><technique_common>
			<dynamic_friction>0.5</dynamic_friction><restitution>0.0</restitution>
			<static_friction>0.5</static_friction></technique_common></physics_material>
	</library_physics_materials>
	<library_physics_models>
		<physics_model id="ball-PX" name="ball-PX"><rigid_body name="ball-RB"><technique_common>
			<instance_physics_material url="#ball-PxMaterial"/>
			<shape><sphere><radius>0.5</radius></sphere></shape>
			<dynamic>true</dynamic><mass>1.0</mass></technique_common></rigid_body></physics_model>
		<physics_model id="floor-PX" name="floor-PX"><rigid_body name="floor-RB"><technique_common>
			<shape><box><half_extends>7.5 1.5 0.0</half_extends></box></shape>
			<dynamic>false</dynamic><mass>0</mass></technique_common></rigid_body></physics_model>
	</library_physics_models>
	<library_physics_scenes>
		<physics_scene id="Scene-Physics" name="Scene-Physics">
			<instance_physics_model url="#ball-PX"><instance_rigid_body target="#ball"/></instance_physics_model>
			<instance_physics_model url="#floor-PX"><instance_rigid_body target="#floor"/></instance_physics_model>
			<technique_common><gravity>0 0 -9.81</gravity></technique_common>
		</physics_scene>
	</library_physics_scenes>
	<library_visual_scenes><visual_scene id="Scene" name="Scene">
		<node id="ball" name="ball"><translate>1 2 3</translate><rotate>0 0 1 90</rotate>
			<rotate>0 1 0 0</rotate><rotate>1 0 0 0</rotate><scale>1.00000 1.00000 1.00000</scale></node>
		<node id="floor" name="floor"/>
	</visual_scene></library_visual_scenes>
	<scene><instance_visual_scene url="#Scene"/><instance_physics_scene url="#Scene-Physics"/></scene>
</COLLADA>
)";
}

/// Bullet's converter: a mass of 0 for what does not move, inertia of 0, a constraint with the world,
/// infinite limits, matrices.
std::string bulletSample() {
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><contributor><authoring_tool>Bullet Physics SDK (BulletColladaConverter)</authoring_tool></contributor>
    <up_axis>Y_UP</up_axis></asset>
  <library_physics_models><physics_model id="model">
    <rigid_body sid="door-RigidBody" name="door-RigidBody"><technique_common><dynamic>true</dynamic>
      <mass>5</mass><inertia>0.4 0.5 0.1</inertia>
      <shape><box><half_extents>0.5 1 0.05</half_extents></box></shape></technique_common></rigid_body>
    <rigid_body sid="wall-RigidBody" name="wall-RigidBody"><technique_common><dynamic>true</dynamic>
      <mass>0</mass><inertia>0 0 0</inertia>
      <shape><cylinder><height>2</height><radius>1 1</radius></cylinder></shape></technique_common></rigid_body>
    <rigid_constraint sid="hinge"><ref_attachment><translate>0.5 1 0</translate></ref_attachment>
      <attachment rigid_body="door-RigidBody"><translate>-0.5 0 0</translate></attachment>
      <technique_common><enabled>true</enabled><interpenetrate>false</interpenetrate><limits>
        <swing_cone_and_twist><min>0 -INF 0</min><max>0 INF 0</max></swing_cone_and_twist>
        <linear><min>0 0 0</min><max>0 0 0</max></linear></limits></technique_common></rigid_constraint>
  </physics_model></library_physics_models>
  <library_physics_scenes><physics_scene id="Scene-Physics" name="MyPhysicsScene">
    <instance_physics_model url="#model">
      <instance_rigid_body body="door-RigidBody" target="#door"><technique_common>
        <angular_velocity>0 90 0</angular_velocity><velocity>0 0 0</velocity></technique_common>
      </instance_rigid_body>
      <instance_rigid_body body="wall-RigidBody" target="#wall"><technique_common/></instance_rigid_body>
      <instance_rigid_constraint constraint="hinge"/>
    </instance_physics_model>
    <technique_common><gravity>0 -10 0</gravity></technique_common>
  </physics_scene></library_physics_scenes>
  <library_visual_scenes><visual_scene id="Scene">
    <node id="door"><matrix>1 0 0 1  0 1 0 1  0 0 1 0  0 0 0 1</matrix></node>
    <node id="wall"><matrix>0 0 1 4  0 1 0 5  -1 0 0 6  0 0 0 1</matrix></node>
  </visual_scene></library_visual_scenes>
  <scene><instance_physics_scene url="#Scene-Physics"/><instance_visual_scene url="#Scene"/></scene>
</COLLADA>
)";
}

/// PhysX tools: shapes placed before their geometry, densities, materials of shapes, mass frames, tapered
/// shapes, planes, bodies joined by name.
std::string physxSample() {
  return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><contributor><authoring_tool>NXUSTREAM</authoring_tool></contributor><up_axis>Y_UP</up_axis></asset>
  <library_physics_materials><physics_material id="pmat0_0-PhysicsMaterial" name="pmat0_0"><technique_common>
    <dynamic_friction>0.5</dynamic_friction></technique_common></physics_material></library_physics_materials>
  <library_physics_models><physics_model id="Scene0-PhysicsModel">
    <rigid_body sid="a-RigidBody" name="a"><technique_common>
      <shape><translate>0 1 0</translate><rotate>1 0 0 90</rotate>
        <instance_physics_material url="#pmat0_0-PhysicsMaterial"/><density>10</density>
        <extra><technique profile="PhysX"><group>0</group></technique></extra>
        <capsule><radius>1 1</radius><height>2</height></capsule></shape>
      <shape><tapered_cylinder><height>2</height><radius1>0 0</radius1><radius2>1 1</radius2></tapered_cylinder>
        <translate>0 -1 0</translate></shape>
      <dynamic>true</dynamic><mass>40</mass>
      <mass_frame><translate>0 0.25 0</translate><rotate>1 0 0 0</rotate></mass_frame><inertia>1 2 3</inertia>
    </technique_common></rigid_body>
    <rigid_body sid="b-RigidBody" name="b"><technique_common><dynamic>false</dynamic><density>1</density>
      <shape><plane><equation>0 2 0 -4</equation></plane></shape></technique_common></rigid_body>
    <rigid_constraint sid="j-RigidConstraint"><ref_attachment rigid_body="#b-RigidBody"/>
      <attachment rigid_body="#a-RigidBody"/><technique_common><enabled>1</enabled>
      <interpenetrate>true</interpenetrate><limits><linear><min>-INF -1 0</min><max>INF INF 0</max></linear>
      </limits><spring><linear><stiffness>5</stiffness></linear></spring></technique_common></rigid_constraint>
  </physics_model></library_physics_models>
  <library_physics_scenes><physics_scene id="Scene0">
    <instance_physics_model url="#Scene0-PhysicsModel">
      <instance_rigid_body target="#a-Node" body="a-RigidBody"/>
      <instance_rigid_body target="#b-Node" body="b-RigidBody"/>
      <instance_rigid_constraint constraint="j-RigidConstraint"/>
    </instance_physics_model><technique_common/></physics_scene></library_physics_scenes>
  <library_visual_scenes><visual_scene id="Scene0-Visual">
    <node id="a-Node" name="a"><translate>0 5 0</translate></node><node id="b-Node" name="b"/>
  </visual_scene></library_visual_scenes>
  <scene><instance_physics_scene url="#Scene0"/><instance_visual_scene url="#Scene0-Visual"/></scene>
</COLLADA>
)";
}

/// COLLADA 1.5: another namespace, capsules with three radii, bodies found by path, and a brep.
std::string newerSample() {
  return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2008/03/COLLADASchema" version="1.5.0">
  <asset><created>2009-01-01T00:00:00Z</created><modified>2009-01-01T00:00:00Z</modified></asset>
  <library_joints/>
  <library_geometries><geometry id="solid"><brep/></geometry></library_geometries>
  <library_physics_models><physics_model id="arm">
    <rigid_body sid="upper" id="arm.upper"><technique_common><mass>2</mass>
      <shape><capsule><height>1</height><radius>0.2 0.2 0.2</radius></capsule></shape>
      <shape><instance_geometry url="#solid"/></shape></technique_common></rigid_body>
    <rigid_body sid="lower"><technique_common><mass>1</mass>
      <shape><cylinder><height>1</height><radius>0.1 0.3</radius></cylinder></shape></technique_common>
    </rigid_body>
    <rigid_constraint sid="elbow"><ref_attachment rigid_body="arm/upper"><translate>0 -0.5 0</translate>
      </ref_attachment><attachment rigid_body="arm/lower"><translate>0 0.5 0</translate></attachment>
      <technique_common/></rigid_constraint>
  </physics_model></library_physics_models>
  <library_physics_scenes><physics_scene id="physics">
    <instance_physics_model url="#arm" sid="left">
      <instance_rigid_body body="arm/upper" target="#upper-node"><technique_common/></instance_rigid_body>
      <instance_rigid_body body="lower" target="#lower-node"><technique_common/></instance_rigid_body>
      <instance_rigid_constraint constraint="elbow"/></instance_physics_model>
    <technique_common><gravity>0 -9.81 0</gravity></technique_common>
  </physics_scene></library_physics_scenes>
  <library_visual_scenes><visual_scene id="visual">
    <node id="upper-node"><translate>0 2 0</translate><node id="lower-node"><translate>0 -1 0</translate></node>
    </node></visual_scene></library_visual_scenes>
  <scene><instance_physics_scene url="#physics"/><instance_visual_scene url="#visual"/></scene>
</COLLADA>
)";
}

}  // namespace

std::string SceneFile::text() const {
  return "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"" + version + "\">\n" +
         "<asset>" + asset + "</asset>\n" + libraries +
         "\n<library_physics_models><physics_model id=\"m\"><rigid_body sid=\"b\"><technique_common>\n" +
         common + "</technique_common></rigid_body></physics_model>\n" + models +
         "</library_physics_models>\n<library_visual_scenes><visual_scene id=\"v\">\n" + nodes +
         "</visual_scene></library_visual_scenes>\n<library_physics_scenes><physics_scene id=\"s\">\n" +
         instances + "\n<technique_common>" + world +
         "</technique_common></physics_scene></library_physics_scenes>\n" + scene + "</COLLADA>\n";
}

std::vector<Sample> exporterSamples() {
  return {{"Maya", mayaSample()},
          {"Blender", blenderSample()},
          {"Bullet", bulletSample()},
          {"PhysX", physxSample()},
          {"Newer", newerSample()}};
}

std::string exporterSample(const std::string& name) {
  for (const Sample& sample : exporterSamples()) {
    if (sample.name == name) {
      return sample.text;
    }
  }
  return {};
}

PhysicsDocument parsed(const std::string& text) {
  auto document = parseColladaDocument(text, "test.dae");
  EXPECT_TRUE(document.has_value()) << document.error().message;
  return document ? *document : PhysicsDocument{};
}

void expectNear(const Vec3& actual, const Vec3& expected, float tolerance) {
  EXPECT_LT(glm::length(actual - expected), tolerance)
      << actual.x << " " << actual.y << " " << actual.z << " instead of " << expected.x << " " << expected.y
      << " " << expected.z;
}

}  // namespace scatter::test
