#include <scree/vtk/frames.hpp>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdio>

#include <scree/output/appended_file.hpp>
#include <scree/output/output_folder.hpp>

namespace scree {

namespace {

namespace fs = std::filesystem;

std::string name_of(std::size_t number) {
    char name[40];
    std::snprintf(name, sizeof name, "frame_%06zu.vtp", number);
    return name;
}

/// The surfaces of bodies, gathered.
class Surfaces {
  public:
    Surfaces() {
        points_->SetDataTypeToDouble();
        velocities_->SetName("velocity");
        velocities_->SetNumberOfComponents(3);
        numbers_->SetName("body");
        turns_->SetName("angular_velocity");
        turns_->SetNumberOfComponents(3);
    }

    void add(int number, const ShownMesh& mesh, double size, const BodyRecord& body) {
        for (std::size_t first = 0; first + 2 < mesh.corners.size(); first += 3) {
            vtkIdType corners[3];
            for (std::size_t i = 0; i < 3; ++i) {
                corners[i] = add_point(size * mesh.corners[first + i].position, body);
            }
            triangles_->InsertNextCell(3, corners);
            numbers_->InsertNextValue(number);
            turns_->InsertNextTuple(body.angular_velocity.data());
        }
    }

    /// As VTK's XML, at a time [s].
    [[nodiscard]] std::string bytes(double time) {
        vtkNew<vtkPolyData> data;
        data->SetPoints(points_);
        data->SetPolys(triangles_);
        data->GetPointData()->SetVectors(velocities_);
        data->GetCellData()->SetScalars(numbers_);
        data->GetCellData()->AddArray(turns_);
        vtkNew<vtkDoubleArray> moment;
        moment->SetName("TimeValue");  // ParaView's word for it
        moment->InsertNextValue(time);
        data->GetFieldData()->AddArray(moment);
        vtkNew<vtkXMLPolyDataWriter> writer;
        writer->SetInputData(data);
        writer->WriteToOutputStringOn();
        writer->Write();
        return writer->GetOutputString();
    }

  private:
    vtkIdType add_point(const Vec3& in_file, const BodyRecord& body) {
        const Vec3 arm = body.pose.orientation * in_file;
        const Vec3 velocity = body.velocity + body.angular_velocity.cross(arm);
        velocities_->InsertNextTuple(velocity.data());
        return points_->InsertNextPoint(Vec3(body.pose.position + arm).data());
    }

    vtkNew<vtkPoints> points_;
    vtkNew<vtkCellArray> triangles_;
    vtkNew<vtkDoubleArray> velocities_, turns_;
    vtkNew<vtkIntArray> numbers_;
};

}  // namespace

VtkFrames::VtkFrames(fs::path folder, ShownScene scene)
    : folder_(std::move(folder)), scene_(std::move(scene)) {
    std::error_code error;
    fs::create_directories(folder_ / "frames", error);
    if (error) {
        throw OutputError(folder_ / "frames", error.message());
    }
}

fs::path VtkFrames::frame(std::size_t number) const {
    return folder_ / "frames" / name_of(number);
}

void VtkFrames::write(std::size_t number, double time, std::span<const BodyRecord> bodies) {
    Surfaces surfaces;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const ShownBody& shown = scene_.bodies[b];
        surfaces.add(static_cast<int>(b), scene_.meshes[shown.mesh], shown.size, bodies[b]);
    }
    AppendedFile file(frame(number));
    file.append(surfaces.bytes(time));
    file.close();
}

void VtkFrames::write_list(std::span<const double> times) {
    std::string list =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
    for (std::size_t i = 0; i < times.size(); ++i) {
        char line[120];
        std::snprintf(line, sizeof line, "    <DataSet timestep=\"%.17g\" part=\"0\" file=\"frames/%s\"/>\n",
                      times[i], name_of(i).c_str());
        list += line;
    }
    write_whole(folder_ / "frames.pvd", list + "  </Collection>\n</VTKFile>\n");
    std::error_code error;
    for (std::size_t i = times.size(); fs::remove(frame(i), error); ++i) {
    }
}

}  // namespace scree
