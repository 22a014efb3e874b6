#include "check_ply.hpp"

#include <fstream>
#include <string>

#include <scree/mesh_io/load_mesh.hpp>

#include "ply_header.hpp"
#include "shown.hpp"

namespace scree {

namespace {

/// Goes through the binary data. Returns false where they end too early.
class Walk {
  public:
    Walk(std::istream& stream, std::uint64_t size, PlyFormat format)
        : stream_(stream), left_(size), format_(format) {}

    bool pass(const PlyElement& element) {
        if (!element.has_list()) {
            const std::uint64_t size = element.size();
            return size == 0 || (element.count <= left_ / size && skip(element.count * size));
        }
        for (std::uint64_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& property : element.properties) {
                if (!pass(property)) {
                    return false;
                }
            }
        }
        return true;
    }

  private:
    bool pass(const PlyProperty& property) {
        if (property.length == 0) {
            return skip(property.size);
        }
        if (property.length > left_) {
            return false;
        }
        const std::uint64_t length = number(property.length);
        return length <= left_ && skip(length * property.size);
    }

    bool skip(std::uint64_t bytes) {
        if (bytes > left_) {
            return false;
        }
        left_ -= bytes;
        stream_.ignore(static_cast<std::streamsize>(bytes));
        return static_cast<bool>(stream_);
    }

    std::uint64_t number(std::uint64_t bytes) {
        std::uint64_t value = 0;
        for (std::uint64_t i = 0; i < bytes; ++i) {
            const auto byte = static_cast<std::uint64_t>(static_cast<unsigned char>(stream_.get()));
            value = format_ == PlyFormat::big_endian ? value << 8 | byte : value | byte << (8 * i);
        }
        left_ -= bytes;
        return value;
    }

    std::istream& stream_;
    std::uint64_t left_;  ///< [bytes]
    PlyFormat format_;
};

}  // namespace

void check_ply(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string line;
    if (!next_line(stream, line) || !line.starts_with("ply")) {
        return;
    }
    const PlyHeader header = read_ply_header(stream, file);
    if (header.format == PlyFormat::ascii || !stream) {
        return;
    }
    const auto begin = static_cast<std::uint64_t>(stream.tellg());
    Walk walk(stream, std::filesystem::file_size(file) - begin, header.format);
    for (const PlyElement& element : header.elements) {
        if (!walk.pass(element)) {
            throw MeshError(file.string() + ": found a file that ends within its element " +
                            shown(element.name) + ", expected all " + std::to_string(element.count));
        }
    }
}

}  // namespace scree
