#include "btHybridProvenDistance.h"

#include <algorithm>
#include <cmath>

namespace
{
struct ExactPoint
{
	double m[3];
};

double dot(const ExactPoint& a, const ExactPoint& b)
{
	return a.m[0] * b.m[0] + a.m[1] * b.m[1] + a.m[2] * b.m[2];
}

// A shape at its pose, in double precision but for its support function.
class Side
{
	const btConvexShape* m_shape;
	double m_basis[3][3];
	double m_origin[3];

public:
	Side(const btConvexShape* shape, const btTransform& pose, const btVector3& from) : m_shape(shape)
	{
		for (int row = 0; row < 3; row++)
		{
			for (int column = 0; column < 3; column++)
				m_basis[row][column] = double(pose.getBasis()[row][column]);
			m_origin[row] = double(pose.getOrigin()[row]) - double(from[row]);
		}
	}

	ExactPoint furthest(const ExactPoint& direction, double sign) const
	{
		btVector3 local;
		for (int column = 0; column < 3; column++)
		{
			double sum = 0;
			for (int row = 0; row < 3; row++)
				sum += m_basis[row][column] * direction.m[row];
			local[column] = btScalar(sign * sum);
		}
		const btVector3 vertex = m_shape->localGetSupportVertexWithoutMarginNonVirtual(local);
		ExactPoint point;
		for (int row = 0; row < 3; row++)
		{
			point.m[row] = m_origin[row];
			for (int column = 0; column < 3; column++)
				point.m[row] += m_basis[row][column] * double(vertex[column]);
		}
		return point;
	}
};

// Up to four points and the one of their hull that is nearest to the origin.
class Simplex
{
	ExactPoint m_points[4];
	int m_count;

public:
	Simplex() : m_count(0)
	{
	}

	// Finds the nearest point anew and drops the points that it does not need. False if this brings nothing nearer.
	bool add(const ExactPoint& point, ExactPoint& nearest)
	{
		m_points[m_count++] = point;
		const double before = dot(nearest, nearest);
		double least = before;
		int best = 0;
		for (int subset = 1; subset < (1 << m_count); subset++)
		{
			ExactPoint candidate;
			if (!project(subset, candidate) || dot(candidate, candidate) >= least)
				continue;
			least = dot(candidate, candidate);
			nearest = candidate;
			best = subset;
		}
		if (best == 0)
			return false;
		keep(best);
		return m_count < 4;
	}

private:
	void keep(int subset)
	{
		int kept = 0;
		for (int i = 0; i < m_count; i++)
			if (subset & (1 << i))
				m_points[kept++] = m_points[i];
		m_count = kept;
	}

	// The point nearest to the origin of the plane through some of the points; false if it is outside of their hull.
	bool project(int subset, ExactPoint& nearest) const
	{
		const ExactPoint* corners[4];
		int count = 0;
		for (int i = 0; i < m_count; i++)
			if (subset & (1 << i))
				corners[count++] = &m_points[i];
		double weights[4];
		if (!solve(corners, count, weights))
			return false;
		for (int axis = 0; axis < 3; axis++)
		{
			nearest.m[axis] = 0;
			for (int i = 0; i < count; i++)
				nearest.m[axis] += weights[i] * corners[i]->m[axis];
		}
		return true;
	}

	// Minimises |c0 + sum of w_i (c_i - c0)| by Gauss on the normal equations.
	static bool solve(const ExactPoint* const* corners, int count, double* weights)
	{
		double rows[3][4];
		const int unknowns = count - 1;
		for (int i = 0; i < unknowns; i++)
		{
			const ExactPoint edge = less(*corners[i + 1], *corners[0]);
			for (int j = 0; j < unknowns; j++)
				rows[i][j] = dot(edge, less(*corners[j + 1], *corners[0]));
			rows[i][unknowns] = -dot(edge, *corners[0]);
		}
		if (!eliminate(rows, unknowns))
			return false;
		weights[0] = 1;
		for (int i = 0; i < unknowns; i++)
		{
			weights[i + 1] = rows[i][unknowns];
			weights[0] -= weights[i + 1];
		}
		for (int i = 0; i < count; i++)
			if (!(weights[i] >= 0))
				return false;
		return true;
	}

	static bool eliminate(double rows[3][4], int unknowns)
	{
		for (int i = 0; i < unknowns; i++)
		{
			int pivot = i;
			for (int k = i + 1; k < unknowns; k++)
				if (std::abs(rows[k][i]) > std::abs(rows[pivot][i]))
					pivot = k;
			if (!(std::abs(rows[pivot][i]) > 0))
				return false;
			std::swap(rows[i], rows[pivot]);
			for (int k = 0; k < unknowns; k++)
			{
				const double factor = k == i ? 0 : rows[k][i] / rows[i][i];
				for (int j = i; j <= unknowns; j++)
					rows[k][j] -= factor * rows[i][j];
			}
		}
		for (int i = 0; i < unknowns; i++)
			rows[i][unknowns] /= rows[i][i];
		return true;
	}

	static ExactPoint less(const ExactPoint& a, const ExactPoint& b)
	{
		const ExactPoint difference = {{a.m[0] - b.m[0], a.m[1] - b.m[1], a.m[2] - b.m[2]}};
		return difference;
	}
};
}  // namespace

btHybridProvenDistance::btHybridProvenDistance(const btConvexShape* shapeA, const btTransform& a,
                                               const btConvexShape* shapeB, const btTransform& b)
{
	const int mostIterations = 500;
	const double enough = 1e-9;
	const Side sideA(shapeA, a, b.getOrigin());
	const Side sideB(shapeB, b, b.getOrigin());
	const double margins = double(shapeA->getMarginNonVirtual()) + double(shapeB->getMarginNonVirtual());
	const ExactPoint first = {{1, 0, 0}};
	Simplex simplex;
	// A point of A less a point of B; it moves towards the origin.
	ExactPoint nearest = {{1e30, 0, 0}};
	double atLeast = 0;
	ExactPoint direction = first;
	for (int i = 0; i < mostIterations; i++)
	{
		const ExactPoint onA = sideA.furthest(direction, -1);
		const ExactPoint onB = sideB.furthest(direction, 1);
		const ExactPoint corner = {{onA.m[0] - onB.m[0], onA.m[1] - onB.m[1], onA.m[2] - onB.m[2]}};
		atLeast = std::max(atLeast, dot(corner, direction));
		if (!simplex.add(corner, nearest))
			break;
		const double length = std::sqrt(dot(nearest, nearest));
		if (!(length - atLeast > enough * length))
			break;
		for (int axis = 0; axis < 3; axis++)
			direction.m[axis] = nearest.m[axis] / length;
	}
	m_cores = std::sqrt(dot(nearest, nearest));
	m_atLeast = atLeast - margins;
	m_atMost = m_cores - margins;
}
