#include <scree/output/contacts_csv.hpp>

namespace scree {

namespace {

void add(CsvFile& csv, const Vec3& vector) {
    csv.add(vector.x()).add(vector.y()).add(vector.z());
}

}  // namespace

ContactsCsv::ContactsCsv(const std::filesystem::path& file, std::optional<std::uint64_t> kept)
    : csv_(file, "t,a,b,px,py,pz,nx,ny,nz,volume,area,depth,fn,ftx,fty,ftz,slip", kept) {}

void ContactsCsv::write(double time, std::span<const Contact> contacts,
                        std::span<const ContactResult> results, std::span<const std::string> names) {
    for (std::size_t i = 0; i < results.size(); ++i) {
        const ContactResult& result = results[i];
        if (!result.touching) {
            continue;
        }
        const double normal_force = result.law.normal_force;
        csv_.add(time);
        csv_.add(names[static_cast<std::size_t>(contacts[i].a.body)]);
        csv_.add(names[static_cast<std::size_t>(contacts[i].b.body)]);
        add(csv_, result.point);
        add(csv_, result.normal);
        csv_.add(result.volume).add(result.area).add(result.depth).add(normal_force);
        add(csv_, result.law.force - normal_force * result.normal);
        csv_.add(result.slip_speed).end_row();
    }
    csv_.flush();
}

}  // namespace scree
