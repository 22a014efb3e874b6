#include <scree/output/bodies_csv.hpp>

namespace scree {

BodiesCsv::BodiesCsv(const std::filesystem::path& file, std::optional<std::uint64_t> kept)
    : csv_(file, "t,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz", kept) {}

void BodiesCsv::write(double time, std::span<const BodyRecord> bodies) {
    for (const BodyRecord& body : bodies) {
        const Quat& q = body.pose.orientation;
        csv_.add(time).add(body.name);
        for (const double value : body.pose.position) {
            csv_.add(value);
        }
        csv_.add(q.w()).add(q.x()).add(q.y()).add(q.z());
        for (const Vec3& vector : {body.velocity, body.angular_velocity}) {
            csv_.add(vector.x()).add(vector.y()).add(vector.z());
        }
        csv_.end_row();
    }
    csv_.flush();
}

}  // namespace scree
