#include <filesystem>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>

#include <scree/output/contacts_csv.hpp>
#include <scree/output/energy_csv.hpp>

using namespace scree;

namespace {

namespace fs = std::filesystem;

const fs::path table = fs::temp_directory_path() / "scree_event_tables.csv";

std::string take_contents() {
    std::ostringstream text;
    text << std::ifstream(table).rdbuf();
    fs::remove(table);
    return text.str();
}

}  // namespace

TEST_CASE("energy.csv has the ledger's entries", "[output]") {
    EnergyLedger ledger;
    ledger.kinetic = 1;
    ledger.lost_friction = 2;
    ledger.residual = -0.5;
    EnergyCsv(table).write(0.25, ledger);
    CHECK(take_contents() ==
          "t,kinetic,gravity,normal_elastic,tangential_elastic,torsional_elastic,rolling_elastic,cohesive,"
          "lost_normal_damping,lost_tangential_damping,lost_friction,lost_torsion,lost_rolling,lost_cohesion,"
          "work_applied,residual\n"
          "0.25,1,0,0,0,0,0,0,0,0,2,0,0,0,0,-0.5\n");
}

TEST_CASE("contacts.csv has the pairs that touch", "[output]") {
    std::vector<Contact> contacts(2);
    contacts[1].a.body = 1;
    contacts[1].b.body = 2;
    std::vector<ContactResult> results(2);
    results[1].touching = true;
    results[1].law.force = {3, 4, 10};
    results[1].law.normal_force = 10;
    results[1].point = {1, 2, 3};
    results[1].volume = 0.5;
    results[1].area = 0.25;
    results[1].depth = 0.125;
    results[1].slip_speed = 7;
    const std::vector<std::string> names = {"floor", "a", "b"};
    ContactsCsv(table).write(0.5, contacts, results, names);
    CHECK(take_contents() ==
          "t,a,b,px,py,pz,nx,ny,nz,volume,area,depth,fn,ftx,fty,ftz,slip\n"
          "0.5,a,b,1,2,3,0,0,1,0.5,0.25,0.125,10,3,4,0,7\n");
}
