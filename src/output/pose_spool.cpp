#include <scree/output/pose_spool.hpp>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include <scree/output/output_folder.hpp>

namespace scree {

namespace {

using Packed = Eigen::Matrix<float, 7, 1>;  // position, then x, y, z, w

struct Head {
    double time;  // s
    double contacts;
};

Packed packed(const Pose& pose) {
    Packed numbers;
    numbers << pose.position.cast<float>(), pose.orientation.coeffs().cast<float>();
    return numbers;
}

Pose unpacked(const char* bytes) {
    Packed numbers;
    std::memcpy(numbers.data(), bytes, sizeof numbers);
    const Eigen::Vector4d turn = numbers.tail<4>().cast<double>();
    return {numbers.head<3>().cast<double>(), Quat(turn).normalized()};
}

void append(const void* data, std::size_t size, std::string& bytes) {
    bytes.append(static_cast<const char*>(data), size);
}

}  // namespace

PoseSpool::PoseSpool(const std::filesystem::path& file, std::size_t bodies, std::optional<std::uint64_t> kept)
    : file_(kept ? AppendedFile(file, *kept) : AppendedFile(file)), bodies_(bodies) {
    if (file_.size() % frame_bytes() != 0) {
        throw OutputError(file, std::to_string(file_.size()) + " bytes",
                          "a multiple of " + std::to_string(frame_bytes()));
    }
}

std::size_t PoseSpool::frame_bytes() const {
    return sizeof(Head) + bodies_ * sizeof(Packed);
}

void PoseSpool::add(double time, std::size_t contacts, std::span<const Pose> poses) {
    const Head head{time, static_cast<double>(contacts)};
    bytes_.clear();
    append(&head, sizeof head, bytes_);
    for (const Pose& pose : poses) {
        const Packed numbers = packed(pose);
        append(numbers.data(), sizeof numbers, bytes_);
    }
    file_.append(bytes_);
}

void PoseSpool::read(std::size_t stride, const Take& take) const {
    std::ifstream stream(file_.path(), std::ios::binary);
    std::string bytes(frame_bytes(), '\0');
    std::vector<Pose> poses(bodies_);
    const std::size_t count = frames();
    for (std::size_t next = 0; next < count + stride - 1; next += stride) {
        stream.seekg(static_cast<std::streamoff>(std::min(next, count - 1) * frame_bytes()));
        if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
            throw OutputError(file_.path(), "it cut short", "all of its frames");
        }
        Head head{};
        std::memcpy(&head, bytes.data(), sizeof head);
        for (std::size_t b = 0; b < bodies_; ++b) {
            poses[b] = unpacked(bytes.data() + sizeof head + b * sizeof(Packed));
        }
        take(head.time, head.contacts, poses);
    }
}

}  // namespace scree
