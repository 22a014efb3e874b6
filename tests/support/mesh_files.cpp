#include <cstdint>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>

#include <scree/mesh/convex_polyhedron.hpp>

#include <tests/support/mesh_files.hpp>

namespace scree::test {

namespace {

template <class T>
void append(std::string& bytes, const T& value) {
    const std::size_t size = bytes.size();
    bytes.resize(size + sizeof(T));
    std::memcpy(bytes.data() + size, &value, sizeof(T));
}

void append(std::string& bytes, const Vec3& point) {
    for (const double x : point) {
        append(bytes, static_cast<float>(x));
    }
}

std::ostringstream exact_stream() {
    std::ostringstream stream;
    stream.precision(9);  // reads back to the same single-precision number
    return stream;
}

std::string base64(const std::string& bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text.push_back(i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63U] : '=');
        }
    }
    return text;
}

std::string list(const Vec3& v) {
    std::ostringstream stream = exact_stream();
    stream << '[' << v.x() << ',' << v.y() << ',' << v.z() << ']';
    return stream.str();
}

/// The numbers of a binary PLY file.
std::string ply_numbers(const TriangleMesh& mesh, bool big_endian) {
    std::string bytes;
    const auto add = [&](const auto& value) {
        std::string own;
        append(own, value);
        bytes += big_endian ? std::string(own.rbegin(), own.rend()) : own;
    };
    for (const Vec3& v : mesh.vertices) {
        for (const double x : v) {
            add(static_cast<float>(x));
        }
    }
    for (const auto& triangle : mesh.triangles) {
        add(std::uint8_t{3});
        for (const int i : triangle) {
            add(static_cast<std::int32_t>(i));
        }
    }
    return bytes;
}

/// The parts of a glTF file that describe its meshes.
struct GltfParts {
    std::string meshes, accessors, views, bytes;

    void add(const TriangleMesh& mesh) {
        Eigen::AlignedBox3d box;
        const std::size_t start = bytes.size();
        for (const Vec3& v : mesh.vertices) {
            append(bytes, v);
            box.extend(v);
        }
        const std::size_t points = bytes.size();
        for (const auto& triangle : mesh.triangles) {
            for (const int i : triangle) {
                append(bytes, static_cast<std::uint32_t>(i));
            }
        }
        std::ostringstream out = exact_stream();
        out << R"({"bufferView":)" << number_ << R"(,"componentType":5126,"type":"VEC3","count":)"
            << mesh.vertices.size() << R"(,"min":)" << list(box.min()) << R"(,"max":)" << list(box.max())
            << R"(},{"bufferView":)" << number_ + 1 << R"(,"componentType":5125,"type":"SCALAR","count":)"
            << 3 * mesh.triangles.size() << "}";
        accessors += comma() + out.str();
        views += comma() + view(start, points) + "," + view(points, bytes.size());
        meshes += comma() + R"({"primitives":[{"attributes":{"POSITION":)" + std::to_string(number_) +
                  R"(},"indices":)" + std::to_string(number_ + 1) + "}]}";
        number_ += 2;
    }

  private:
    [[nodiscard]] std::string comma() const { return number_ > 0 ? "," : ""; }
    static std::string view(std::size_t begin, std::size_t end) {
        return R"({"buffer":0,"byteOffset":)" + std::to_string(begin) + R"(,"byteLength":)" +
               std::to_string(end - begin) + "}";
    }
    int number_ = 0;  // of accessors so far
};

/// The two chunks of a binary glTF file.
std::string glb(std::string json, std::string bytes) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    std::string file = "glTF";
    append(file, std::uint32_t{2});
    append(file, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + bytes.size()));
    append(file, static_cast<std::uint32_t>(json.size()));
    file += "JSON" + json;
    append(file, static_cast<std::uint32_t>(bytes.size()));
    return file + std::string("BIN\0", 4) + bytes;
}

}  // namespace

TriangleMesh cube_mesh() {
    const ConvexPolyhedron box = make_box(Vec3::Ones());
    TriangleMesh mesh{box.vertices, {}};
    for (int f = 0; f < box.face_count(); ++f) {
        const int first = box.face_begin[f];
        for (int h = first + 1; h + 1 < box.face_begin[f + 1]; ++h) {
            mesh.triangles.push_back(
                {box.half_edges[first].vertex, box.half_edges[h].vertex, box.half_edges[h + 1].vertex});
        }
    }
    return mesh;
}

std::string contents(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

MeshFiles::MeshFiles()
    : folder_(std::filesystem::temp_directory_path() /
              ("scree_meshes_" + std::to_string(std::random_device()()))) {
    std::filesystem::create_directory(folder_);
}

MeshFiles::~MeshFiles() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

std::filesystem::path MeshFiles::text(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
}

std::filesystem::path MeshFiles::obj(const std::string& name, const TriangleMesh& mesh) const {
    std::ostringstream out = exact_stream();
    for (const Vec3& v : mesh.vertices) {
        out << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
    }
    for (const auto& [a, b, c] : mesh.triangles) {
        out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    }
    return text(name, out.str());
}

std::filesystem::path MeshFiles::ascii_stl(const std::string& name, const TriangleMesh& mesh) const {
    std::ostringstream out = exact_stream();
    out << "solid mesh\n";
    for (const auto& triangle : mesh.triangles) {
        out << "facet normal 0 0 0\nouter loop\n";
        for (const int i : triangle) {
            const Vec3& v = mesh.vertices[i];
            out << "vertex " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
        }
        out << "endloop\nendfacet\n";
    }
    out << "endsolid mesh\n";
    return text(name, out.str());
}

std::filesystem::path MeshFiles::binary_stl(const std::string& name, const TriangleMesh& mesh) const {
    std::string bytes(80, ' ');
    append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles) {
        append(bytes, Vec3(Vec3::Zero()));
        for (const int i : triangle) {
            append(bytes, mesh.vertices[i]);
        }
        append(bytes, std::uint16_t{0});
    }
    return text(name, bytes);
}

std::filesystem::path MeshFiles::ply(const std::string& name, const TriangleMesh& mesh, PlyKind kind) const {
    const char* format = kind == PlyKind::ascii           ? "ascii"
                         : kind == PlyKind::little_endian ? "binary_little_endian"
                                                          : "binary_big_endian";
    std::ostringstream out = exact_stream();
    out << "ply\nformat " << format << " 1.0\nelement vertex " << mesh.vertices.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.triangles.size()
        << "\nproperty list uchar int vertex_indices\nend_header\n";
    if (kind != PlyKind::ascii) {
        return text(name, out.str() + ply_numbers(mesh, kind == PlyKind::big_endian));
    }
    for (const Vec3& v : mesh.vertices) {
        out << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
    }
    for (const auto& [a, b, c] : mesh.triangles) {
        out << "3 " << a << ' ' << b << ' ' << c << '\n';
    }
    return text(name, out.str());
}

std::filesystem::path MeshFiles::gltf(const std::string& name, const TriangleMesh& mesh, const Vec3& shift,
                                      const Vec3& scale) const {
    std::ostringstream nodes = exact_stream();
    nodes << R"([{"mesh":0,"translation":)" << list(shift) << R"(,"scale":)" << list(scale) << "}]";
    return gltf(name, {mesh}, nodes.str(), GltfBuffer::embedded);
}

std::filesystem::path MeshFiles::gltf(const std::string& name, const std::vector<TriangleMesh>& meshes,
                                      const std::string& nodes, GltfBuffer where) const {
    GltfParts parts;
    for (const TriangleMesh& mesh : meshes) {
        parts.add(mesh);
    }
    std::string uri;
    if (where == GltfBuffer::embedded) {
        uri = R"(,"uri":"data:application/octet-stream;base64,)" + base64(parts.bytes) + "\"";
    } else if (where == GltfBuffer::beside) {
        text(name + ".bin", parts.bytes);
        uri = R"(,"uri":")" + name + ".bin\"";
    }
    const std::string json =
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
        R"(,"meshes":[)" + parts.meshes + R"(],"accessors":[)" + parts.accessors + R"(],"bufferViews":[)" +
        parts.views + R"(],"buffers":[{"byteLength":)" + std::to_string(parts.bytes.size()) + uri + "}]}";
    return text(name, where == GltfBuffer::binary ? glb(json, parts.bytes) : json);
}

std::filesystem::path MeshFiles::collada(const std::string& name, const std::string& axis, double unit,
                                         const std::string& nodes) const {
    std::ostringstream out;
    out << R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="unit" meter=")"
        << unit << "\"/>" << axis << R"(</asset>
<library_geometries><geometry id="corner"><mesh>
<source id="points"><float_array id="numbers" count="12">0 0 0 1 0 0 0 2 0 0 0 3</float_array>
<technique_common><accessor source="#numbers" count="4" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source>
<vertices id="vertices"><input semantic="POSITION" source="#points"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#vertices" offset="0"/>
<p>0 2 1 0 1 3 1 2 3 2 0 3</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="scene">)"
        << nodes << R"(</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
)";
    return text(name, out.str());
}

}  // namespace scree::test
