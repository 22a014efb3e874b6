#include <scree/output/shown_scene.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace scree {

namespace {

constexpr int segments = 32;  // of a full turn

/// Adds triangles at a pose.
class Surface {
  public:
    Surface(ShownMesh& mesh, const Pose& pose) : mesh_(mesh), pose_(pose) {}

    void corner(const Vec3& position, const Vec3& normal) {
        mesh_.corners.push_back({pose_ * position, pose_.orientation * normal});
    }

    /// A flat one, counter-clockwise seen from outside.
    void polygon(const std::vector<Vec3>& loop, const Vec3& normal) {
        for (std::size_t i = 2; i < loop.size(); ++i) {
            corner(loop[0], normal);
            corner(loop[i - 1], normal);
            corner(loop[i], normal);
        }
    }

    /// What a profile (distance from the z axis, height) sweeps out about that axis, upwards; each of its
    /// points has the normal (outward, up).
    struct ProfilePoint {
        Eigen::Vector2d place, normal;
    };
    void swept(const std::vector<ProfilePoint>& profile) {
        for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
            for (int s = 0; s < segments; ++s) {
                band(profile[i], profile[i + 1], s, s + 1);
            }
        }
    }

  private:
    static Vec3 turned(const Eigen::Vector2d& v, int segment) {
        const double angle = 2 * std::numbers::pi * (segment % segments) / segments;
        return {v.x() * std::cos(angle), v.x() * std::sin(angle), v.y()};
    }
    void at(const ProfilePoint& point, int segment) {
        corner(turned(point.place, segment), turned(point.normal, segment));
    }
    void band(const ProfilePoint& low, const ProfilePoint& high, int from, int to) {
        if (low.place.x() > 0) {
            at(low, from), at(low, to), at(high, to);
        }
        if (high.place.x() > 0) {
            at(low, from), at(high, to), at(high, from);
        }
    }

    ShownMesh& mesh_;
    const Pose& pose_;
};

/// A quarter or half circle of a profile, from one angle above the horizon to another.
void add_arc(double radius, double height, double from, double to,
             std::vector<Surface::ProfilePoint>& profile) {
    const int count =
        std::max(1, static_cast<int>(std::lround((to - from) / (2 * std::numbers::pi) * segments)));
    for (int i = 0; i <= count; ++i) {
        const double angle = from + (to - from) * i / count;
        const bool pole = std::abs(std::abs(angle) - std::numbers::pi / 2) < 1e-9;
        const Eigen::Vector2d normal(pole ? 0 : std::cos(angle), std::sin(angle));
        profile.push_back({radius * normal + Eigen::Vector2d(0, height), normal});
    }
}

/// Adds the surface of each kind of shape.
struct Maker {
    Surface surface;
    const ShownGround& ground;

    void operator()(const ConvexPolyhedron& solid) {
        for (int f = 0; f < solid.face_count(); ++f) {
            const auto face = static_cast<std::size_t>(f);
            std::vector<Vec3> loop;
            for (int e = solid.face_begin[face]; e < solid.face_begin[face + 1]; ++e) {
                loop.push_back(solid.vertices[static_cast<std::size_t>(
                    solid.half_edges[static_cast<std::size_t>(e)].vertex)]);
            }
            surface.polygon(loop, solid.planes[face].normal);
        }
    }
    void operator()(const HalfSpace& half_space) {
        const Vec3 across = ground.half_width * half_space.normal.unitOrthogonal();
        const Vec3 along = half_space.normal.cross(across);
        const Vec3 middle =
            ground.about + (half_space.offset - half_space.normal.dot(ground.about)) * half_space.normal;
        surface.polygon({middle - across - along, middle + across - along, middle + across + along,
                         middle - across + along},
                        half_space.normal);
    }
    void operator()(const Sphere& sphere) {
        constexpr double quarter = std::numbers::pi / 2;
        std::vector<Surface::ProfilePoint> profile;
        add_arc(sphere.radius, 0, -quarter, quarter, profile);
        surface.swept(profile);
    }
    void operator()(const Capsule& capsule) {
        constexpr double quarter = std::numbers::pi / 2;
        std::vector<Surface::ProfilePoint> profile;
        add_arc(capsule.radius, -capsule.half_length, -quarter, 0, profile);
        add_arc(capsule.radius, capsule.half_length, 0, quarter, profile);
        surface.swept(profile);
    }
    void operator()(const Frustum& frustum) {
        const double height = frustum.half_height;
        const Eigen::Vector2d down(0, -1), up(0, 1);
        const Eigen::Vector2d side = Eigen::Vector2d(2 * height, frustum.bottom - frustum.top).normalized();
        surface.swept({{{0, -height}, down}, {{frustum.bottom, -height}, down}});
        surface.swept({{{frustum.bottom, -height}, side}, {{frustum.top, height}, side}});
        surface.swept({{{frustum.top, height}, up}, {{0, height}, up}});
    }
    void operator()(const OpenSurface& /*surface*/) const {
        throw std::invalid_argument("of an open surface only its bounds are known");
    }
};

}  // namespace

ShownMesh shown_mesh(const std::string& name, const Shape& shape, const Pose& pose,
                     const ShownGround& ground) {
    ShownMesh mesh;
    mesh.name = name;
    std::visit(Maker{Surface(mesh, pose), ground}, shape);
    return mesh;
}

ShownMesh shown_surface(const std::string& name, const TriangleMesh& triangles) {
    ShownMesh mesh;
    mesh.name = name;
    const Pose place;
    Surface surface(mesh, place);
    for (const auto& [a, b, c] : triangles.triangles) {
        const std::vector<Vec3> loop = {triangles.vertices[static_cast<std::size_t>(a)],
                                        triangles.vertices[static_cast<std::size_t>(b)],
                                        triangles.vertices[static_cast<std::size_t>(c)]};
        const Vec3 area = (loop[1] - loop[0]).cross(loop[2] - loop[0]);
        if (area.norm() > 0) {
            surface.polygon(loop, area.normalized());
        }
    }
    return mesh;
}

}  // namespace scree
