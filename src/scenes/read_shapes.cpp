#include "readers.hpp"
#include "values.hpp"

namespace scree {

namespace {

constexpr double smallest_normal = 1e-15;

std::filesystem::path file_name(const Node& node) {
    return name(node);
}

constexpr Choice<Parts> parts_words[] = {
    {"hull", Parts::hull}, {"decompose", Parts::decompose}, {"surface", Parts::surface}};

void read_part_file(const Node& node, std::filesystem::path& file) {
    file = file_name(node);
}

void read_parts(const Node& node, MeshShape& mesh) {
    if (node.value().is_array()) {
        mesh.parts = Parts::files;
        mesh.part_files = list(node, read_part_file);
    } else {
        mesh.parts = choice<parts_words>(node);
    }
}

constexpr Field<MeshShape> mesh_fields[] = {
    {"mesh", into<&MeshShape::file, file_name>, required},
    {"scale", into<&MeshShape::scale, scale>},
    {"parts", read_parts},
};

constexpr Field<BoxShape> box_fields[] = {{"box", into<&BoxShape::edges, lengths>, required}};

constexpr Field<Sphere> sphere_fields[] = {{"sphere", into<&Sphere::radius, positive>, required}};

constexpr Field<HalfSpace> plane_fields[] = {
    {"normal", into<&HalfSpace::normal, vector>, required},
    {"offset", into<&HalfSpace::offset, number>},
};

void read_plane(const Node& node, HalfSpace& half_space) {
    read_fields(node, plane_fields, half_space);
    const double length = half_space.normal.norm();
    if (!(length > smallest_normal)) {
        Node(node, "normal").refuse("a vector that is not zero");
    }
    half_space.normal /= length;
    half_space.offset /= length;
}

constexpr Field<HalfSpace> half_space_fields[] = {{"half_space", read_plane, required}};

/// The kinds of shapes by the key that only they have.
template <auto& fields, class T>
void read_kind(const Node& node, ShapeDescription& shape) {
    T kind;
    read_fields(node, fields, kind);
    shape = kind;
}

constexpr Field<ShapeDescription> kinds[] = {
    {"mesh", read_kind<mesh_fields, MeshShape>},
    {"box", read_kind<box_fields, BoxShape>},
    {"sphere", read_kind<sphere_fields, Sphere>},
    {"half_space", read_kind<half_space_fields, HalfSpace>},
};

constexpr std::string_view shape_keys[] = {"mesh", "box", "sphere", "half_space", "scale", "parts"};

}  // namespace

void read_shape(const Node& node, ShapeDescription& shape) {
    check_keys(node, shape_keys);
    const Field<ShapeDescription>* found = nullptr;
    for (const auto& kind : kinds) {
        if (!node.value().contains(kind.key)) {
            continue;
        }
        if (found != nullptr) {
            node.refuse(in_quotes(found->key) + " and " + in_quotes(kind.key), "one of them");
        }
        found = &kind;
    }
    if (found == nullptr) {
        node.refuse("no kind of shape", "one of \"mesh\", \"box\", \"sphere\", \"half_space\"");
    }
    found->read(node, shape);
}

}  // namespace scree
