#include "packed_mesh.hpp"

#include <cstring>

#include <scree/mesh_io/load_mesh.hpp>

namespace scree {

namespace {

constexpr char with_mesh = 'm';
constexpr char with_error = 'e';

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
    const std::size_t count = values.size();
    bytes.append(reinterpret_cast<const char*>(&count), sizeof(count));
    bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(T));
}

/// Takes values from the front; throws when they are not all there.
template <class T>
std::vector<T> take(std::string_view& bytes) {
    std::size_t count = 0;
    if (bytes.size() >= sizeof(count)) {
        std::memcpy(&count, bytes.data(), sizeof(count));
        bytes.remove_prefix(sizeof(count));
    }
    if (count > bytes.size() / sizeof(T)) {
        throw MeshError("found only a part of a mesh, expected all of it");
    }
    std::vector<T> values(count);
    std::memcpy(static_cast<void*>(values.data()), bytes.data(), count * sizeof(T));
    bytes.remove_prefix(count * sizeof(T));
    return values;
}

}  // namespace

std::string packed(const TriangleMesh& mesh) {
    std::string bytes(1, with_mesh);
    append(bytes, mesh.vertices);
    append(bytes, mesh.triangles);
    return bytes;
}

std::string packed_error(const std::string& message) {
    return with_error + message;
}

TriangleMesh unpacked(const std::string& bytes) {
    std::string_view left = bytes;
    const char kind = left.empty() ? with_mesh : left.front();
    left.remove_prefix(left.empty() ? 0 : 1);
    if (kind == with_error) {
        throw MeshError(std::string(left));
    }
    TriangleMesh mesh;
    mesh.vertices = take<Vec3>(left);
    mesh.triangles = take<std::array<int, 3>>(left);
    return mesh;
}

}  // namespace scree
