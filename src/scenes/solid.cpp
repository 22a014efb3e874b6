#include <scree/scenes/solid.hpp>

#include <limits>
#include <numbers>
#include <sstream>

#include <scree/detect/collision_shapes.hpp>
#include <scree/detect/convert.hpp>
#include <scree/mesh_io/describe_mesh.hpp>

namespace scree {

namespace {

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

/// Makes the solid of each kind of shape.
struct Maker {
    const std::filesystem::path& folder;

    Solid operator()(const MeshShape& description) const {
        const MeshDescription mesh = describe_mesh(folder / description.file, description.scale);
        Solid solid;
        solid.body_in_file = {mesh.hull_mass.centroid, mesh.hull_mass.principal_axes};
        solid.shape =
            std::make_shared<const Shape>(transformed(mesh.hull.solid, solid.body_in_file.inverse()));
        solid.native = solid.collision = std::make_shared<PolyhedronShape>(solid.shape);
        solid.volume = mesh.hull_mass.volume;
        solid.inertia = mesh.hull_mass.principal_inertia;
        solid.note = describe(mesh);
        return solid;
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

}  // namespace

SavedState geometry_of(const Solid& solid) {
    SavedState geometry;
    StateWriter with(geometry);
    with(solid.body_in_file.position, solid.body_in_file.orientation, solid.volume, solid.inertia,
         solid.shape->index());
    std::visit(GeometryWriter{with}, *solid.shape);
    return geometry;
}

Solid make_solid(const ShapeDescription& shape, const std::filesystem::path& folder) {
    return std::visit(Maker{folder}, shape);
}

Solid scaled(const Solid& solid, double factor) {
    Solid other = solid;
    if (const auto* sphere = std::get_if<Sphere>(solid.shape.get())) {
        other.shape = std::make_shared<const Shape>(Sphere{factor * sphere->radius});
        other.native = other.collision = std::make_shared<btSphereShape>(factor * sphere->radius);
    } else {
        ConvexPolyhedron larger = std::get<ConvexPolyhedron>(*solid.shape);
        for (Vec3& vertex : larger.vertices) {
            vertex *= factor;
        }
        for (Plane& plane : larger.planes) {
            plane.offset *= factor;
        }
        larger.radius *= factor;
        larger.width *= factor;
        other.shape = std::make_shared<const Shape>(std::move(larger));
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
