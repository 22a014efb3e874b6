#include <tests/support/bad_meshes.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace scree::test {

namespace {

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

/// The text with one part of it changed, which must be there.
std::string changed(std::string text, const std::string& part, const std::string& instead) {
    const std::size_t at = text.find(part);
    if (at == std::string::npos) {
        throw std::logic_error("no \"" + part + "\" to change");
    }
    return text.replace(at, part.size(), instead);
}

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) {
        all += text;
    }
    return all;
}

template <class T>
std::string with_bytes(std::string bytes, std::size_t at, const T& value) {
    std::memcpy(bytes.data() + at, &value, sizeof(T));
    return bytes;
}

/// Writes the files, one by one.
class Writer {
  public:
    explicit Writer(const MeshFiles& files) : files_(files) {}

    void add(const std::string& name, const std::string& text, const std::string& message) {
        bad_.push_back({files_.text(name, text), message});
    }
    void add_path(const std::filesystem::path& file, const std::string& message) {
        bad_.push_back({file, message});
    }
    std::vector<BadMesh> take() { return std::move(bad_); }

  private:
    const MeshFiles& files_;
    std::vector<BadMesh> bad_;
};

void add_no_meshes(const MeshFiles& files, Writer& bad) {
    bad.add_path(files.folder() / "none.obj", "found no such file");
    bad.add_path(files.folder(), "found something that is no file");
    std::filesystem::create_directory(files.folder() / "folder.obj");
    bad.add_path(files.folder() / "folder.obj", "found something that is no file");
    bad.add_path("/dev/zero", "found something that is no file");
    bad.add("empty.obj", "", "found an empty file");
    bad.add("stone.txt", "a stone\n", "found no mesh in it");
    bad.add("picture.obj", "\x89PNG\r\n\x1a\n" + std::string(100, '\0'), "found no triangles");
    bad.add("wide.obj", changed(corners + faces, "v", std::string("\xff\xfev\0", 4)), "found");
}

void add_obj(Writer& bad) {
    const std::string whole = corners + faces;
    const std::string out_of_range = "vertex index out of range";
    bad.add("index.obj", corners + "f 1 2 99\n" + faces, out_of_range);
    bad.add("long_index.obj", corners + "f 1 2 99999999999999999999\n" + faces, out_of_range);
    bad.add("negative.obj", corners + "f -9 1 2\n" + faces, out_of_range);
    bad.add("zero.obj", corners + "f 0 1 2\n" + faces, "Invalid face index");
    bad.add("words.obj", corners + "f a b c\n", "Invalid face index");
    bad.add("points.obj", corners + "p 1\np 2\n", "found no triangles");
    bad.add("lines.obj", corners + "l 1 2\nf 3 4\n", "found no triangles");
    bad.add("short.obj", changed(whole, "v 0 0 1", "v 0 0"), out_of_range);
    bad.add("word.obj", changed(whole, "v 0 0 1", "v 0 0 up"), "found");
    bad.add("nan.obj", changed(whole, "v 0 0 1", "v 0 0 nan"), "not finite");
    bad.add("infinite.obj", changed(whole, "v 0 0 1", "v 0 0 1e60"), "not finite");
    bad.add("far.obj", changed(whole, "v 0 0 1", "v 0 0 1e30"), "expected at most 1e+09 m");
    bad.add("tiny.obj", changed(whole, corners, "v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nv 0 0 1e-30\n"),
            "expected at least 1e-09 m");
    bad.add("flat.obj", changed(whole, "v 0 0 1", "v 1 1 0"), "lie in one plane");
    bad.add("line.obj", changed(whole, corners, "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\n"), "lie on one line");
    bad.add("point.obj", changed(whole, corners, repeated("v 1 2 3\n", 4)), "at least four points, found 1");
    bad.add("triangle.obj", corners + "f 1 2 3\n", "at least four points, found 3");
    bad.add("bytes.obj", repeated("\x01\x80\xff\n v f", 500), "found no triangles");
    bad.add("long.obj", "v " + std::string(1 << 20, '1') + "\n", "found no triangles");
}

void add_stl(const MeshFiles& files, Writer& bad) {
    const std::string whole = contents(files.binary_stl("whole.stl", cube_mesh()));
    const std::string ascii = contents(files.ascii_stl("ascii.stl", cube_mesh()));
    constexpr std::size_t count = 80;            // where the number of triangles is
    constexpr std::size_t number = 84 + 12 + 4;  // and the y of the first corner
    bad.add("many.stl", with_bytes(whole, count, std::uint32_t{0xffffffff}), "found no mesh in it");
    bad.add("more.stl", with_bytes(whole, count, std::uint32_t{13}), "found no mesh in it");
    bad.add("no.stl", with_bytes(whole.substr(0, 84), count, std::uint32_t{0}), "found no mesh in it");
    bad.add("cut.stl", whole.substr(0, 200), "found no mesh in it");
    bad.add("head.stl", whole.substr(0, 80), "found no mesh in it");
    bad.add("nan.stl", with_bytes(whole, number, std::numeric_limits<float>::quiet_NaN()), "not finite");
    bad.add("infinite.stl", with_bytes(whole, number, std::numeric_limits<float>::infinity()), "not finite");
    bad.add("cut_ascii.stl", ascii.substr(0, ascii.find("endfacet") - 30), "found no mesh in it");
    bad.add("word.stl", changed(ascii, "vertex", "vertex x"), "found no mesh in it");
    bad.add("nothing.stl", "solid a\nendsolid a\n", "found no triangles");
    bad.add("solids.stl", repeated("solid a\n", 100'000), "found no triangles");
    bad.add("garbage.stl", std::string(300, '\x01'), "found no mesh in it");
}

void add_ply(const MeshFiles& files, Writer& bad) {
    const std::string whole = contents(files.ply("whole.ply", cube_mesh()));
    const std::string bytes = contents(files.ply("bytes.ply", cube_mesh(), PlyKind::little_endian));
    const std::string other = contents(files.ply("other.ply", cube_mesh(), PlyKind::big_endian));
    const std::size_t data = bytes.find("end_header\n") + 11;
    const std::size_t first_face = data + std::size_t{8} * 12;
    bad.add("index.ply", changed(whole, "\n3 0", "\n3 77"), "found a face with vertex 77");
    bad.add("negative.ply", changed(whole, "\n3 0", "\n3 -1"), "found a face with vertex 4294967295");
    bad.add("huge.ply", changed(whole, "vertex 8", "vertex 4000000000"), "announces vertex 4000000000");
    bad.add("less.ply", changed(whole, "vertex 8", "vertex -8"), "announces vertex -8");
    bad.add("word.ply", changed(whole, "vertex 8", "vertex many"), "found no mesh in it");
    bad.add("format.ply", changed(whole, "ascii", "binary_middle_endian"), "found the format");
    bad.add("no_format.ply", changed(whole, "format ascii 1.0\n", ""), "found no mesh in it");
    bad.add("no_end.ply", changed(whole, "end_header\n", ""), "found");
    bad.add("type.ply", changed(whole, "float x", "quux x"), "found");
    bad.add("nan.ply", changed(whole, "end_header\n", "end_header\nnan nan nan\n"), "not finite");
    bad.add("magic.ply", "ply\n", "found no mesh in it");
    bad.add("head.ply", bytes.substr(0, data), "ends within its element vertex");
    bad.add("cut.ply", bytes.substr(0, bytes.size() - 5), "ends within its element face");
    bad.add("cut_other.ply", other.substr(0, other.size() - 5), "ends within its element face");
    bad.add("over.ply", changed(bytes, "face 12", "face 120"), "ends within its element face");
    bad.add("long_list.ply", with_bytes(bytes, first_face, std::uint8_t{255}),
            "ends within its element face");
    bad.add("far_index.ply", with_bytes(bytes, first_face + 1, std::int32_t{1'000'000'000}),
            "found a face with vertex 1000000000");
    bad.add("nan_bytes.ply", with_bytes(bytes, data, std::numeric_limits<float>::quiet_NaN()), "not finite");
}

void add_gltf(const MeshFiles& files, Writer& bad) {
    const std::string nodes = R"([{"mesh":0}])";
    const std::string whole = contents(files.gltf("whole.gltf", {cube_mesh()}, nodes, GltfBuffer::embedded));
    const std::string beside = contents(files.gltf("beside.gltf", {cube_mesh()}, nodes, GltfBuffer::beside));
    const auto add = [&](const std::string& name, const std::string& part, const std::string& instead,
                         const std::string& message) {
        bad.add(name + ".gltf", changed(whole, part, instead), message);
    };
    add("count", R"("count":8)", R"("count":1000000000)", "out of range");
    add("less", R"("count":8)", R"("count":-8)", "found no mesh in it");
    add("view", R"("byteLength":96)", R"("byteLength":4000000000)", "found no mesh in it");
    add("offset", R"("byteOffset":96)", R"("byteOffset":4000000000)", "found no mesh in it");
    add("mesh", R"("mesh":0)", R"("mesh":7)", "out of bounds");
    add("accessor", R"("indices":1)", R"("indices":9)", "out of bounds");
    add("cycle", R"({"mesh":0})", R"({"mesh":0,"children":[0]})", "recursive");
    add("child", R"({"mesh":0})", R"({"mesh":0,"children":[5]})", "out of bounds");
    add("scene", R"("scene":0)", R"("scene":5)", "found no mesh in it");
    add("type", R"("VEC3")", R"("MAT4")", "found no mesh in it");
    add("component", R"("componentType":5126)", R"("componentType":1)", "Component Type 1");
    add("infinite", R"({"mesh":0})", R"({"mesh":0,"scale":[1e39,1,1]})", "not finite");
    add("flattened", R"({"mesh":0})", R"({"mesh":0,"scale":[0,1,1]})", "lie in one plane");
    add("matrix", R"({"mesh":0})", R"({"mesh":0,"matrix":"identity"})", "found no mesh in it");
    add("lines", R"("indices":1)", R"("indices":1,"mode":1)", "found no triangles");
    add("stride", R"("byteLength":96)", R"("byteLength":96,"byteStride":100000)", "found no mesh in it");
    add("base64", "base64,", "base64,!", "found");
    add("version", R"("version":"2.0")", R"("version":"9.0")", "found no mesh in it");
    bad.add("missing.gltf", changed(beside, "beside.gltf.bin", "none.bin"), "could not open");
    bad.add("device.gltf", changed(beside, "beside.gltf.bin", "/dev/zero"), "could not open");
    bad.add("self.gltf", changed(beside, "beside.gltf.bin", "self.gltf"), "found");
    bad.add("open.gltf", "{", "found no mesh in it");
    bad.add("deep.gltf", std::string(100'000, '['), "found no mesh in it");
    // Each node is there twice: 2⁴⁰ nodes at the end.
    std::string doubled;
    for (int i = 1; i <= 40; ++i) {
        doubled += R"({"children":[)" + std::to_string(i) + "," + std::to_string(i) + "]},";
    }
    add("doubled", R"({"mesh":0})", doubled + R"({"mesh":0})", "found no mesh in it");

    const std::string binary = contents(files.gltf("whole.glb", {cube_mesh()}, nodes, GltfBuffer::binary));
    bad.add("length.glb", with_bytes(binary, 12, std::uint32_t{0xffffffff}), "found no mesh in it");
    bad.add("version.glb", with_bytes(binary, 4, std::uint32_t{99}), "found no mesh in it");
    bad.add("cut.glb", binary.substr(0, binary.size() - 30), "found no mesh in it");
    bad.add("head.glb", binary.substr(0, 12), "found no mesh in it");
}

void add_collada(const MeshFiles& files, Writer& bad) {
    const std::string axis = "<up_axis>Z_UP</up_axis>";
    const std::string whole = contents(files.collada("whole.dae", axis, 1));
    const auto add = [&](const std::string& name, const std::string& part, const std::string& instead,
                         const std::string& message) {
        bad.add(name + ".dae", changed(whole, part, instead), message);
    };
    add("unit", R"(meter="1")", R"(meter="0")", "found the unit \"0\"");
    add("negative", R"(meter="1")", R"(meter="-1")", "found the unit \"-1\"");
    add("nan_unit", R"(meter="1")", R"(meter="nan")", "found the unit \"nan\"");
    add("word", R"(meter="1")", R"(meter="inch")", "found the unit \"inch\"");
    add("axis", "Z_UP", "UPWARDS", "found the upward axis \"UPWARDS\"");
    add("numbers", R"(count="12">0 0 0)", R"(count="12">)", "found no mesh in it");
    add("many", R"(count="12")", R"(count="4000000000")", "found no mesh in it");
    add("no_count", R"(count="12")", R"(count="-3")", "found no mesh in it");
    add("words", "0 0 0 1 0 0", "a b c d e f", "found no mesh in it");
    add("nan", ">0 0 0 1", ">nan 0 0 1", "not finite");
    add("stride", R"(stride="3")", R"(stride="4000000000")", "found no mesh in it");
    add("triangles", R"(<triangles count="4">)", R"(<triangles count="4000000000">)", "found no mesh in it");
    add("offset", R"(offset="0")", R"(offset="5")", "found no mesh in it");
    add("index", "2 0 3</p>", "2 0 99</p>", "Invalid data index");
    add("empty", "<p>0 2 1 0 1 3 1 2 3 2 0 3</p>", "<p></p>", "found no mesh in it");
    add("nowhere", R"(url="#corner")", R"(url="#none")", "found no");
    add("matrix", "<node>", "<node><matrix>1 2 3</matrix>", "found no mesh in it");
    add("flattened", "<node>", "<node><scale>1 1 0</scale>", "found");
    add("itself", "<node>", R"(<node id="a"><instance_node url="#a"/>)", "found no mesh in it");
    add("cut", whole.substr(whole.find("<vertices")), "", "found no mesh in it");
    bad.add("open.dae", std::string(1000, '<'), "found no mesh in it");
    bad.add("nothing.dae", R"(<?xml version="1.0"?><COLLADA version="1.4.1"></COLLADA>)", "found no");
    add("deep", "<node>", repeated("<node>", 20'000), "found no mesh in it");
}

}  // namespace

std::vector<BadMesh> bad_meshes(const MeshFiles& files) {
    Writer bad(files);
    add_no_meshes(files, bad);
    add_obj(bad);
    add_stl(files, bad);
    add_ply(files, bad);
    add_gltf(files, bad);
    add_collada(files, bad);
    return bad.take();
}

}  // namespace scree::test
