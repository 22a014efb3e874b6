#include <scree/scenes/solid.hpp>

#include <limits>
#include <numbers>
#include <sstream>

#include <scree/detect/collision_shapes.hpp>
#include <scree/detect/convert.hpp>
#include <scree/mesh_io/describe_mesh.hpp>
#include <scree/overlap/surface_plates.hpp>

#include "convex_parts.hpp"

namespace scree {

namespace {

constexpr double plate_thickness = 0.05;  // of the diagonal of a surface

std::string describe(const MeshDescription& mesh) {
    if (mesh.convex) {
        return "";
    }
    if (!mesh.closed) {
        return "the mesh is not closed, its hull stands for it";
    }
    std::ostringstream text;
    text << "the mesh is not convex, its hull stands for it: the mesh fills " << mesh.volume_ratio()
         << " of that";
    return text.str();
}

/// Bullet's compound of a solid's parts, which lives as long as they.
class PartsShape final : public btCompoundShape {
  public:
    explicit PartsShape(const std::vector<SolidPart>& parts)
        : btCompoundShape(true, static_cast<int>(parts.size())) {
        for (const SolidPart& part : parts) {
            children_.push_back(std::make_unique<PolyhedronShape>(part.shape));
            addChildShape(to_bullet(Pose{part.position, Quat::Identity()}), children_.back().get());
        }
    }

  private:
    std::vector<std::unique_ptr<PolyhedronShape>> children_;
};

// Convex solids of the file's frame as parts in the body's, each about its own middle.
void set_parts(const std::vector<ConvexPolyhedron>& solids, Solid& solid) {
    const Pose into_body = solid.body_in_file.inverse();
    for (const ConvexPolyhedron& each : solids) {
        ConvexPolyhedron part = transformed(each, into_body);
        const Vec3 middle = mass_properties(part).centroid;
        part = transformed(part, {-middle, Quat::Identity()});
        solid.parts.push_back({std::make_shared<const Shape>(std::move(part)), middle});
    }
    solid.native = solid.collision = std::make_shared<PartsShape>(solid.parts);
}

// The mass properties are those of the mesh itself.
Solid solid_of_parts(const MeshDescription& mesh, const ConvexParts& parts) {
    Solid solid;
    solid.body_in_file = {mesh.mass.centroid, mesh.mass.principal_axes};
    solid.shape = std::make_shared<const Shape>(transformed(mesh.hull.solid, solid.body_in_file.inverse()));
    set_parts(parts.solids, solid);
    solid.volume = mesh.mass.volume;
    solid.inertia = mesh.mass.principal_inertia;
    std::ostringstream text;
    text << parts.solids.size() << " convex parts fill " << parts.volume_ratio << " of the mesh";
    solid.note = text.str();
    return solid;
}

Solid solid_of_hull(const MeshDescription& mesh) {
    Solid solid;
    solid.body_in_file = {mesh.hull_mass.centroid, mesh.hull_mass.principal_axes};
    solid.shape = std::make_shared<const Shape>(transformed(mesh.hull.solid, solid.body_in_file.inverse()));
    solid.native = solid.collision = std::make_shared<PolyhedronShape>(solid.shape);
    solid.volume = mesh.hull_mass.volume;
    solid.inertia = mesh.hull_mass.principal_inertia;
    solid.note = describe(mesh);
    return solid;
}

// Ground; a body whose mass nobody asks for. What is open looks to where the file says.
Solid surface_solid(const TriangleMesh& file) {
    const Surface oriented = oriented_surface(file);
    const TriangleMesh& mesh = oriented.closed ? oriented.mesh : file;
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : mesh.vertices) {
        box.extend(vertex);
    }
    Solid solid;
    const std::vector<ConvexPolyhedron> plates =
        surface_plates(mesh, plate_thickness * box.diagonal().norm());
    if (plates.empty()) {
        throw std::invalid_argument("a surface without area, expected one with");
    }
    solid.shape = std::make_shared<const Shape>(make_box(
        2 * box.max().cwiseAbs().cwiseMax(box.min().cwiseAbs()) + Vec3::Constant(box.diagonal().norm())));
    set_parts(plates, solid);
    solid.volume = std::numeric_limits<double>::infinity();
    solid.note = "its surface is ground, of " + std::to_string(plates.size()) + " plates";
    return solid;
}

/// Makes the solid of each kind of shape.
struct Maker {
    const std::filesystem::path& folder;

    Solid operator()(const MeshShape& description) const {
        if (description.parts == Parts::surface) {
            return surface_solid(load_mesh(folder / description.file, description.scale));
        }
        const MeshDescription mesh = describe_mesh(folder / description.file, description.scale);
        switch (description.parts) {
            case Parts::files:
                return solid_of_parts(mesh, parts_from_files(description, mesh, folder));
            case Parts::decompose:
                return solid_of_parts(mesh, decomposed(mesh));
            default:
                return solid_of_hull(mesh);
        }
    }

    Solid operator()(const BoxShape& box) const {
        const Vec3 squares = box.edges.cwiseAbs2();
        Solid solid;
        solid.shape = std::make_shared<const Shape>(make_box(box.edges));
        solid.collision = std::make_shared<PolyhedronShape>(solid.shape);
        solid.native = std::make_shared<btBoxShape>(to_bullet(Vec3(0.5 * box.edges)));
        solid.volume = box.edges.prod();
        solid.inertia = solid.volume / 12 * (Vec3::Constant(squares.sum()) - squares);
        return solid;
    }

    Solid operator()(const Sphere& sphere) const {
        const double square = sphere.radius * sphere.radius;
        Solid solid;
        solid.shape = std::make_shared<const Shape>(sphere);
        solid.native = solid.collision = std::make_shared<btSphereShape>(sphere.radius);
        solid.volume = 4.0 / 3.0 * std::numbers::pi * square * sphere.radius;
        solid.inertia = Vec3::Constant(0.4 * solid.volume * square);
        return solid;
    }

    Solid operator()(const HalfSpace& half_space) const {
        Solid solid;
        solid.shape = std::make_shared<const Shape>(half_space);
        solid.native = solid.collision =
            std::make_shared<btStaticPlaneShape>(to_bullet(half_space.normal), half_space.offset);
        solid.volume = std::numeric_limits<double>::infinity();
        return solid;
    }
};

/// A box stays one; what else has faces is what the pair search has.
std::shared_ptr<btCollisionShape> scaled_native(const btCollisionShape& shape, double factor,
                                                std::shared_ptr<btCollisionShape> scaled_collision) {
    if (const auto* box = dynamic_cast<const btBoxShape*>(&shape)) {
        return std::make_shared<btBoxShape>(factor * box->getHalfExtentsWithMargin());
    }
    return scaled_collision;
}

/// Writes what tells a shape from another of its kind.
struct GeometryWriter {
    StateWriter& with;

    void operator()(const ConvexPolyhedron& solid) const { with(solid.vertices); }
    void operator()(const Sphere& sphere) const { with(sphere.radius); }
    void operator()(const HalfSpace& half_space) const { with(half_space.normal, half_space.offset); }
    void operator()(const Frustum& frustum) const { with(frustum.bottom, frustum.top, frustum.half_height); }
    void operator()(const Capsule& capsule) const { with(capsule.radius, capsule.half_length); }
    void operator()(const OpenSurface& surface) const { with(surface.low, surface.high); }
};

// Of a sphere or a polyhedron.
std::shared_ptr<const Shape> scaled_shape(const Shape& shape, double factor) {
    if (const auto* sphere = std::get_if<Sphere>(&shape)) {
        return std::make_shared<const Shape>(Sphere{factor * sphere->radius});
    }
    ConvexPolyhedron larger = std::get<ConvexPolyhedron>(shape);
    for (Vec3& vertex : larger.vertices) {
        vertex *= factor;
    }
    for (Plane& plane : larger.planes) {
        plane.offset *= factor;
    }
    larger.radius *= factor;
    larger.width *= factor;
    return std::make_shared<const Shape>(std::move(larger));
}

}  // namespace

SavedState geometry_of(const Solid& solid) {
    SavedState geometry;
    StateWriter with(geometry);
    with(solid.body_in_file.position, solid.body_in_file.orientation, solid.volume, solid.inertia);
    for_each_part(solid, [&](const Shape& part, const Vec3& position) {
        with(part.index(), position);
        std::visit(GeometryWriter{with}, part);
    });
    return geometry;
}

Solid make_solid(const ShapeDescription& shape, const std::filesystem::path& folder) {
    return std::visit(Maker{folder}, shape);
}

Solid scaled(const Solid& solid, double factor) {
    Solid other = solid;
    other.shape = scaled_shape(*solid.shape, factor);
    if (!solid.parts.empty()) {
        for (SolidPart& part : other.parts) {
            part = {scaled_shape(*part.shape, factor), factor * part.position};
        }
        other.native = other.collision = std::make_shared<PartsShape>(other.parts);
    } else if (const auto* sphere = std::get_if<Sphere>(other.shape.get())) {
        other.native = other.collision = std::make_shared<btSphereShape>(sphere->radius);
    } else {
        other.collision = std::make_shared<PolyhedronShape>(other.shape);
        other.native = scaled_native(*solid.native, factor, other.collision);
    }
    const double cube = factor * factor * factor;
    other.body_in_file.position *= factor;
    other.volume *= cube;
    other.inertia *= cube * factor * factor;
    return other;
}

}  // namespace scree
