// Frames for ParaView, read back by VTK's own reader.

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>

#include <scree/vtk/frames.hpp>

#include <tests/cli/child.hpp>
#include <tests/scenes/busy_scene.hpp>

using namespace scree;
using namespace scree::test;

namespace {

namespace fs = std::filesystem;

vtkNew<vtkXMLPolyDataReader> read(const fs::path& file) {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    REQUIRE(reader->GetErrorCode() == 0);
    return reader;
}

fs::path frame(const fs::path& out, int number) {
    char name[40];
    std::snprintf(name, sizeof name, "frames/frame_%06d.vtp", number);
    return out / name;
}

double time_of(vtkPolyData& data) {
    return data.GetFieldData()->GetArray("TimeValue")->GetTuple1(0);
}

std::vector<double> listed_times(const fs::path& out) {
    std::istringstream list(text_of(out / "frames.pvd"));
    std::vector<double> times;
    for (std::string line; std::getline(list, line);) {
        if (const std::size_t at = line.find("timestep=\""); at != std::string::npos) {
            times.push_back(std::stod(line.substr(at + 10)));
        }
    }
    return times;
}

}  // namespace

TEST_CASE("A frame has each body's surface where it is, with the velocity there", "[vtk]") {
    const Folder folder;
    ShownScene scene;
    const Vec3 edges(0.2, 0.4, 0.6);
    scene.meshes.push_back(shown_mesh("box", make_box(edges), {}));
    scene.bodies = {{"one", 0, 1, true, {}}, {"two", 0, 2, true, {}}};
    const Vec3 place(1, 2, 3);
    const Vec3 velocity(1, 0, -2);
    const Vec3 spin(0, 3, 1);
    const std::vector<BodyRecord> bodies = {
        {"one", {}, Vec3::Zero(), Vec3::Zero()},
        {"two", {place, Quat(Eigen::AngleAxisd(0.5, Vec3::UnitX()))}, velocity, spin}};
    VtkFrames frames(folder.path(), scene);
    frames.write(7, 0.125, bodies);

    const auto reader = read(frame(folder.path(), 7));
    vtkPolyData& data = *reader->GetOutput();
    CHECK(time_of(data) == 0.125);
    REQUIRE(data.GetNumberOfPolys() == 2 * 12);
    REQUIRE(data.GetNumberOfPoints() == 2 * 36);
    vtkDataArray& velocities = *data.GetPointData()->GetArray("velocity");
    vtkDataArray& numbers = *data.GetCellData()->GetArray("body");
    vtkDataArray& spins = *data.GetCellData()->GetArray("angular_velocity");
    for (vtkIdType cell = 0; cell < 24; ++cell) {
        const auto number = static_cast<std::size_t>(numbers.GetTuple1(cell));
        CHECK(number == (cell < 12 ? 0 : 1));
        CHECK(Vec3(spins.GetTuple3(cell)) == bodies[number].angular_velocity);
        for (vtkIdType corner = 0; corner < 3; ++corner) {
            const vtkIdType point = data.GetCell(cell)->GetPointId(static_cast<int>(corner));
            const Vec3 at(data.GetPoint(point));
            const BodyRecord& body = bodies[number];
            const Vec3 in_file = body.pose.inverse() * at;
            CHECK((in_file.cwiseAbs() - 0.5 * scene.bodies[number].size * edges).norm() < 1e-15);
            const Vec3 expected = body.velocity + body.angular_velocity.cross(at - body.pose.position);
            CHECK((Vec3(velocities.GetTuple3(point)) - expected).norm() < 1e-14);
        }
    }
}

TEST_CASE("A run's frames are listed with their times, and go on where it was stopped", "[vtk]") {
    const Folder folder;
    const std::string scene = folder.write("busy.json", busy_scene);
    const auto run = [&](const std::vector<std::string>& words) {
        const Child child(folder, words);
        const int status = child.wait();
        CAPTURE(words, child.errors());
        REQUIRE(status == 0);
    };
    const std::string whole = folder / "whole";
    const std::string parted = folder / "parted";
    run({"run", scene, "--out", whole, "--quiet", "--set", "output.vtk=true", "--until", "0.1"});
    run({"run", scene, "--out", parted, "--quiet", "--set", "output.vtk=true", "--until", "0.04"});
    const std::vector<double> first = listed_times(parted);
    REQUIRE(first.size() > 1);
    run({"resume", parted, "--quiet", "--until", "0.1"});

    const std::vector<double> times = listed_times(whole);
    CHECK(times.size() > first.size());
    CHECK(times == listed_times(parted));
    for (std::size_t i = 0; i < times.size(); ++i) {
        const auto number = static_cast<int>(i);
        CHECK(time_of(*read(frame(whole, number))->GetOutput()) == times[i]);
        CHECK(text_of(frame(whole, number)) == text_of(frame(parted, number)));
    }
    CHECK_FALSE(fs::exists(frame(whole, static_cast<int>(times.size()))));
}
