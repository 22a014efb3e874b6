#include "smooth_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nearest_feature.hpp"

namespace scree {

namespace {

constexpr double pi = std::numbers::pi;

// The cap of height h of a sphere: volume [m³] and height of its centroid above its flat side [m].
struct Cap {
    double volume, centroid;

    Cap(double radius, double h)
        : volume(pi * h * h * (radius - h / 3)), centroid(h * (4 * radius - h) / (4 * (3 * radius - h))) {}
};

double ball_volume(double radius) {
    return 4.0 / 3.0 * pi * radius * radius * radius;
}

// How A's centre moves with ξ, a motion about the overlap's centroid.
Mat36 centre_rate(const ContactGeometry& g) {
    Mat36 rate;
    rate << Mat3::Identity(), cross_matrix(g.centroid);
    return rate;
}

// A sphere's own turning changes nothing, so all derivatives follow from those by the motion of its centre.
void follow_centre(ContactGeometry& g, const Mat3& area_vector_rate, const Mat3& normal_rate) {
    const Mat36 centre = centre_rate(g);
    g.second_moment = g.first_moment * centre.rightCols<3>();
    g.boundary.topRows<3>() = area_vector_rate * centre;
    g.boundary.bottomRows<3>() =
        -cross_matrix(g.area_vector) * centre - cross_matrix(g.centroid) * g.boundary.topRows<3>();
    g.normal_rate = normal_rate * centre;
}

// All of the inner body: no surface vector, and everything moves with that body.
void fill_whole(ContactGeometry& g, double radius, const Vec3& centre, bool is_a) {
    g.centre_line = true;
    g.volume = ball_volume(radius);
    g.centroid = centre;
    if (is_a) {
        g.first_moment = g.volume * Mat3::Identity();
    }
}

// The cap that a plane at `height` under A's centre cuts off; normal_rate is dn by the motion of that centre.
bool fill_cap(ContactGeometry& g, double radius, const Vec3& normal, double height, const Mat3& normal_rate) {
    const double depth = radius - height;
    if (!(depth > 0)) {
        return false;
    }
    g = ContactGeometry{};
    g.normal = normal;
    g.depth = std::min(depth, 2 * radius);
    if (depth >= 2 * radius) {
        fill_whole(g, radius, Vec3::Zero(), true);
        follow_centre(g, Mat3::Zero(), normal_rate);
        return true;
    }
    const Cap part(radius, depth);
    const Mat3 along = normal * normal.transpose();
    const double to_centroid = height + part.centroid;
    g.volume = part.volume;
    g.centroid = -to_centroid * normal;
    g.area = pi * depth * (2 * radius - depth);
    g.area_vector = -g.area * normal;
    g.first_moment =
        g.volume * (Mat3::Identity() - to_centroid * normal_rate) - g.area * part.centroid * along;
    follow_centre(g, 2 * pi * height * along - g.area * normal_rate, normal_rate);
    return true;
}

template <class Solid>
bool near_solid(const Sphere& a, const Pose& pose_a, const Solid& b, double radius_b, const Pose& pose_b,
                ContactGeometry& g) {
    const Vec3 apart = pose_a.position - pose_b.position;
    const double reach = a.radius + radius_b;
    if (apart.squaredNorm() > reach * reach) {
        return false;
    }
    const Mat3 turn = pose_b.orientation.toRotationMatrix();
    const NearestFeature nearest = nearest_feature(b, turn.transpose() * apart);
    return fill_cap(g, a.radius, turn * nearest.normal, nearest.height,
                    turn * nearest.normal_rate * turn.transpose());
}

}  // namespace

bool overlap_cap(const Sphere& a, const Pose& pose_a, const HalfSpace& b, const Pose& pose_b,
                 ContactGeometry& g) {
    const Vec3 normal = pose_b.orientation * b.normal;
    const double height = normal.dot(pose_a.position - pose_b.position) - b.offset;
    if (!fill_cap(g, a.radius, normal, height, Mat3::Zero())) {
        return false;
    }
    g.depth_moment = -g.volume * (height + normal.dot(g.centroid));
    return true;
}

bool overlap_nearest(const Sphere& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b,
                     ContactGeometry& g) {
    return near_solid(a, pose_a, b, b.radius, pose_b, g);
}

bool overlap_nearest(const Sphere& a, const Pose& pose_a, const Frustum& b, const Pose& pose_b,
                     ContactGeometry& g) {
    return near_solid(a, pose_a, b, b.facets.radius, pose_b, g);
}

bool overlap_nearest(const Sphere& a, const Pose& pose_a, const Capsule& b, const Pose& pose_b,
                     ContactGeometry& g) {
    return near_solid(a, pose_a, b, b.half_length + b.radius, pose_b, g);
}

namespace {

// The plane of the circle where two spheres meet, at `to_plane` from A's centre, parts the lens into two
// caps. `turning`: d(normal) by a translation of A.
void fill_lens(double radius_a, double radius_b, double distance, const Mat3& turning, ContactGeometry& g) {
    const double difference = (radius_a - radius_b) * (radius_a + radius_b) / distance;
    const double to_plane = 0.5 * (distance + difference);
    const Cap of_a(radius_a, radius_a - to_plane);
    const Cap of_b(radius_b, radius_b - (distance - to_plane));
    const Mat3 along = g.normal * g.normal.transpose();
    g.volume = of_a.volume + of_b.volume;
    const double beyond = (of_a.volume * of_a.centroid - of_b.volume * of_b.centroid) / g.volume;
    g.centroid = -(to_plane + beyond) * g.normal;
    g.area = pi * (radius_a - to_plane) * (radius_a + to_plane);
    g.area_vector = -g.area * g.normal;
    // A's cap and its flat disc enclose of_a.volume; the disc, facing A, takes its share of ∫ r nᵀ away.
    g.first_moment = of_a.volume * Mat3::Identity() - g.area * beyond * along;
    const double area_rate = -pi * to_plane * (1 - difference / distance);
    follow_centre(g, -area_rate * along - g.area * turning, turning);
}

}  // namespace

bool overlap_lens(const Sphere& a, const Pose& pose_a, const Sphere& b, const Pose& pose_b,
                  ContactGeometry& g) {
    const Vec3 apart = pose_a.position - pose_b.position;
    const double distance = apart.norm();
    const double depth = a.radius + b.radius - distance;
    if (!(depth > 0)) {
        return false;
    }
    const double smaller = std::min(a.radius, b.radius);
    g = ContactGeometry{};
    g.normal = distance > 0 ? Vec3(apart / distance) : Vec3::UnitZ();
    g.depth = std::min(depth, 2 * smaller);
    const Mat3 along = g.normal * g.normal.transpose();
    const Mat3 turning =
        distance > 1e-6 * smaller ? Mat3((Mat3::Identity() - along) / distance) : Mat3(Mat3::Zero());
    if (distance <= std::abs(a.radius - b.radius)) {
        const bool is_a = a.radius <= b.radius;
        fill_whole(g, smaller, is_a ? Vec3(Vec3::Zero()) : Vec3(-apart), is_a);
        follow_centre(g, Mat3::Zero(), turning);
        return true;
    }
    fill_lens(a.radius, b.radius, distance, turning, g);
    return true;
}

}  // namespace scree
