#include <scree/mesh_io/describe_mesh.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace scree {

namespace {

double surface_area(const ConvexPolyhedron& solid) {
    const auto vertex = [&](int h) -> const Vec3& { return solid.vertices[solid.half_edges[h].vertex]; };
    double area = 0;
    for (int f = 0; f < solid.face_count(); ++f) {
        const int first = solid.face_begin[f];
        for (int h = first + 1; h + 1 < solid.face_begin[f + 1]; ++h) {
            area += (vertex(h) - vertex(first)).cross(vertex(h + 1) - vertex(first)).norm() / 2;
        }
    }
    return area;
}

double largest_extent(const ConvexPolyhedron& solid) {
    Eigen::AlignedBox3d box;
    for (const Vec3& v : solid.vertices) {
        box.extend(v);
    }
    return box.sizes().maxCoeff();
}

}  // namespace

MeshDescription describe_mesh(const TriangleMesh& mesh) {
    MeshDescription description;
    description.hull = convex_hull(mesh.vertices);
    description.hull_mass = mass_properties(description.hull.solid);
    description.surface = oriented_surface(mesh);
    description.closed = description.surface.closed;
    description.mass = description.closed ? mass_properties(description.surface.mesh) : description.hull_mass;
    const ConvexPolyhedron& solid = description.hull.solid;
    const double skin = 1e-6 * largest_extent(solid) * surface_area(solid);
    description.convex =
        description.closed && std::abs(description.hull_mass.volume - description.mass.volume) <= skin;
    return description;
}

MeshDescription describe_mesh(const std::filesystem::path& file, const Vec3& scale) {
    const TriangleMesh mesh = load_mesh(file, scale);
    try {
        return describe_mesh(mesh);
    } catch (const std::invalid_argument& error) {
        const std::string reason = error.what();
        const bool complete = reason.find("expected") != std::string::npos;
        throw MeshError(file.string() + ": " + reason + (complete ? "" : ", expected a solid"));
    }
}

}  // namespace scree
