#include "patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "polyhedron_overlap.hpp"

namespace scree {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// Below this sine two faces count as parallel, and the line where they meet as no faster than at this angle:
// the true derivative grows without bound there, over a motion that vanishes with it.
constexpr double least_sine = 1e-3;

const Vec3& corner(const ClippedSolid& solid, int half_edge) {
    return solid.point(solid.half_edges()[at(half_edge)].vertex);
}

// Calls visit(start, end, face tag, tag across) for each edge where a face of B meets a face of A, in the
// sense in which it runs round B's face.
template <class Visit>
void for_each_meeting_edge(const ClippedSolid& solid, Visit&& visit) {
    for (const ClippedSolid::Face& face : solid.faces()) {
        if (face.tag < cut_tags) {
            continue;
        }
        for (int e = face.begin; e < face.end; ++e) {
            const int across = solid.half_edges()[at(e)].across;
            if (across >= cut_tags) {
                continue;
            }
            visit(corner(solid, e), corner(solid, e + 1 < face.end ? e + 1 : face.begin), face.tag, across);
        }
    }
}

// ∫‖ρ‖dA over the triangle from the origin to the edge p → q in the plane with the given normal.
double distance_integral(const Vec3& p, const Vec3& q, const Vec3& normal) {
    const Vec3 along = q - p;
    const double length = along.norm();
    if (length == 0) {
        return 0;
    }
    const double height = p.cross(along).dot(normal) / length;
    const double start = p.dot(along) / length;
    const double end = start + length;
    const double size = std::abs(height);
    if (size <= 1e-12 * length) {
        return 0;
    }
    return height / 6 *
           (end * std::hypot(height, end) - start * std::hypot(height, start) +
            size * size * (std::asinh(end / size) - std::asinh(start / size)));
}

}  // namespace

const Plane& OverlapPlanes::plane(int tag) const {
    return tag < cut_tags ? a[at(tag)] : b[at(tag - cut_tags)];
}

double integrate_volume(const ClippedSolid& solid, ContactGeometry& geometry) {
    const Vec3 reference = solid.point(solid.vertices().front());
    double volume = 0;
    double surface = 0;
    Vec3 weighted = Vec3::Zero();
    for (const ClippedSolid::Face& face : solid.faces()) {
        const Vec3 first = corner(solid, face.begin) - reference;
        Vec3 area = Vec3::Zero();
        for (int e = face.begin + 1; e + 1 < face.end; ++e) {
            const Vec3 second = corner(solid, e) - reference;
            const Vec3 third = corner(solid, e + 1) - reference;
            const Vec3 normal = (second - first).cross(third - first);
            const double share = normal.dot(first);
            volume += share;
            weighted += share * (first + second + third);
            area += normal;
        }
        surface += 0.5 * area.norm();
    }
    geometry.volume = volume / 6;
    geometry.centroid = reference;
    if (volume > 0) {
        geometry.centroid += weighted / (4 * volume);
    }
    return surface;
}

void integrate_patch(const ClippedSolid& solid, const OverlapPlanes& planes, ContactGeometry& g) {
    g.area_vector.setZero();
    g.first_moment = g.volume * Mat3::Identity();
    g.second_moment.setZero();
    for (const ClippedSolid::Face& face : solid.faces()) {
        if (face.tag < cut_tags) {
            continue;
        }
        const Vec3& normal = planes.normal(face.tag);
        const Vec3 first = corner(solid, face.begin) - g.centroid;
        double area = 0;
        Vec3 moment = Vec3::Zero();
        Mat3 second_moment = Mat3::Zero();
        for (int e = face.begin + 1; e + 1 < face.end; ++e) {
            const Vec3 second = corner(solid, e) - g.centroid;
            const Vec3 third = corner(solid, e + 1) - g.centroid;
            const Vec3 sum = first + second + third;
            const double share = 0.5 * (second - first).cross(third - first).dot(normal);
            area += share;
            moment += share / 3 * sum;
            second_moment += share / 12 *
                             (first * first.transpose() + second * second.transpose() +
                              third * third.transpose() + sum * sum.transpose());
        }
        g.area_vector -= area * normal;
        g.first_moment -= moment * normal.transpose();
        g.second_moment -= second_moment * cross_matrix(normal);
    }
}

void integrate_boundary(const ClippedSolid& solid, const OverlapPlanes& planes, ContactGeometry& g) {
    g.boundary.setZero();
    for_each_meeting_edge(solid, [&](const Vec3& start, const Vec3& end, int face, int across) {
        const Vec3& normal_b = planes.normal(face);
        const Vec3& normal_a = planes.normal(across);
        const double sine = std::max(normal_a.cross(normal_b).norm(), least_sine);
        const Vec3 middle = 0.5 * (start + end) - g.centroid;
        const Vec3 half = (0.5 / std::sqrt(3.0)) * (end - start);
        const double weight = -0.5 * (end - start).norm() / sine;
        for (const Vec3& r : {Vec3(middle - half), Vec3(middle + half)}) {
            Eigen::Matrix<double, 6, 1> moved, gained;
            moved << normal_a, r.cross(normal_a);
            gained << normal_b, r.cross(normal_b);
            g.boundary += weight * gained * moved.transpose();
        }
    });
}

void measure_patch(const ClippedSolid& solid, ContactGeometry& g) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    double reach = 0;  // the farthest corner's squared distance from the axis along n
    for (const int v : solid.vertices()) {
        const Vec3 r = solid.point(v) - g.centroid;
        const double height = g.normal.dot(r);
        low = std::min(low, height);
        high = std::max(high, height);
        reach = std::max(reach, r.squaredNorm() - height * height);
    }
    g.depth = high - low;
    g.lever = 0;
    if (g.centre_line) {
        return;
    }
    for_each_meeting_edge(solid, [&](const Vec3& start, const Vec3& end, int, int) {
        g.lever += distance_integral(start - g.centroid, end - g.centroid, g.normal);
    });
    // A patch that folds over itself, seen along n, may have next to no area left.
    g.lever = std::clamp(g.lever / g.area, 0.0, std::sqrt(reach));
}

}  // namespace scree
