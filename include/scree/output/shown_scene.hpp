#pragma once

#include <string>
#include <vector>

#include <scree/mesh/triangle_mesh.hpp>
#include <scree/overlap/shape.hpp>

namespace scree {

/// A surface to be looked at: three corners a triangle, each with the normal by which it is lit.
struct ShownMesh {
    /// Of a triangle.
    struct Corner {
        Vec3 position;  ///< [m]
        Vec3 normal;    ///< unit
    };
    std::string name;             ///< in the file
    std::vector<Corner> corners;  ///< three a triangle, counter-clockwise seen from outside
};

/// The part of a half-space that is shown: a square about the foot of a point.
struct ShownGround {
    Vec3 about = Vec3::Zero();  ///< [m], in the file's frame
    double half_width = 1;      ///< [m]
};

/// The surface of a shape that is at a pose in the file's frame; of a half-space the given part.
ShownMesh shown_mesh(const std::string& name, const Shape& shape, const Pose& pose,
                     const ShownGround& ground = {});

/// Triangles as they are, seen from where they are counter-clockwise.
ShownMesh shown_surface(const std::string& name, const TriangleMesh& triangles);

/// A body to be looked at, by the frame of its file.
struct ShownBody {
    std::string name;      ///< in the file
    std::size_t mesh = 0;  ///< its number
    double size = 1;       ///< factor on the mesh
    bool moves = false;    ///< others stay at their start
    Pose start;            ///< of the file's frame
};

/// Bodies and their meshes, for replays and pictures.
struct ShownScene {
    std::vector<ShownMesh> meshes;  ///< shared by bodies
    std::vector<ShownBody> bodies;  ///< in scene order
};

}  // namespace scree
