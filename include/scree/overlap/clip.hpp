#pragma once

#include <vector>

#include <scree/mesh/convex_polyhedron.hpp>

namespace scree {

/// A convex solid that is cut down by one plane after another, its topology kept: faces stay loops of vertex
/// numbers, and every edge knows the two faces that meet there. A vertex is judged once per plane, so that
/// rounding can bend a face but never tear the surface. Reused from pair to pair: no allocation once the
/// buffers have grown.
class ClippedSolid {
  public:
    /// A face as a run of half-edges.
    struct Face {
        int begin = 0;  ///< of its half-edges
        int end = 0;    ///< one past the last of them
        int tag = 0;    ///< the face's number in the solid it came from, or the tag of the plane that cut it
    };

    /// Starts from a whole polyhedron, in its own frame; its faces are tagged with their numbers.
    void start(const ConvexPolyhedron& solid);

    /// Keeps the part with plane.normal·x ≤ plane.offset. What closes the hole is a face with the given tag.
    /// Returns false when nothing is left.
    bool cut(const Plane& plane, int tag);

    /// The faces that are left; valid until the next cut.
    [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
    /// Half-edges of all faces; `across` is the tag of the face on the other side.
    [[nodiscard]] const std::vector<HalfEdge>& half_edges() const { return half_edges_; }
    /// The place [m] of a vertex, in the frame of the solid it started from.
    [[nodiscard]] const Vec3& point(int vertex) const { return points_[static_cast<std::size_t>(vertex)]; }
    /// Numbers of the vertices that are left.
    [[nodiscard]] const std::vector<int>& vertices() const { return live_; }

  private:
    struct Crossing {
        int inside, outside;  ///< the ends of the edge that the plane crosses
        int vertex;           ///< the new vertex on it
        int next;             ///< the crossing that follows round the hole
        int across;           ///< tag of the face between this crossing and the next
    };

    bool judge(const Plane& plane);
    bool clear_of(const Plane& plane) const;
    void bound();
    int crossing(int inside, int outside);
    void trim_face(const Face& face);
    void close_hole(int tag);

    std::vector<Vec3> points_;
    std::vector<double> height_;  ///< above the present plane, one a point
    std::vector<int> live_;
    std::vector<Face> faces_, trimmed_faces_;
    std::vector<HalfEdge> half_edges_, trimmed_half_edges_;
    std::vector<Crossing> crossings_;
    Vec3 centre_ = Vec3::Zero();  ///< of a ball that holds what is left
    double radius_ = 0;
    int cut_tag_ = 0;
};

}  // namespace scree
