#pragma once

#include <scree/mesh/convex_hull.hpp>
#include <scree/mesh/mass_properties.hpp>
#include <scree/mesh/surface.hpp>
#include <scree/mesh_io/load_mesh.hpp>

namespace scree {

/// A mesh as a solid of density 1 kg/m³, in the file's frame times its scale.
struct MeshDescription {
    MassProperties mass;  ///< of the mesh when it is closed, else of its hull
    bool closed = false;  ///< the surface encloses a volume
    bool convex = false;  ///< closed, and fills its hull but for 10⁻⁶ of the size all over the surface
    Surface surface;      ///< the triangles, facing outward if closed
    ConvexHull hull;      ///< coplanar triangles merged
    MassProperties hull_mass;  ///< of the hull

    /// Of the hull.
    [[nodiscard]] int vertices() const { return static_cast<int>(hull.solid.vertices.size()); }
    /// Of the hull, coplanar triangles merged.
    [[nodiscard]] int faces() const { return hull.solid.face_count(); }
    [[nodiscard]] double hull_volume() const { return hull_mass.volume; }                 ///< [m³]
    [[nodiscard]] double volume_ratio() const { return mass.volume / hull_mass.volume; }  ///< mesh over hull
};

/// Throws std::invalid_argument, naming the reason, for a mesh that spans no volume.
MeshDescription describe_mesh(const TriangleMesh& mesh);

/// The same of a file. All that is wrong with it is a MeshError, which names it.
MeshDescription describe_mesh(const std::filesystem::path& file, const Vec3& scale = Vec3::Ones());

}  // namespace scree
