#include <scree/overlap/clip.hpp>

#include <algorithm>

namespace scree {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

constexpr int visited = -1;

}  // namespace

void ClippedSolid::start(const ConvexPolyhedron& solid) {
    points_.assign(solid.vertices.begin(), solid.vertices.end());
    height_.resize(points_.size());
    live_.resize(points_.size());
    for (std::size_t i = 0; i < live_.size(); ++i) {
        live_[i] = static_cast<int>(i);
    }
    half_edges_.assign(solid.half_edges.begin(), solid.half_edges.end());
    faces_.clear();
    for (int f = 0; f < solid.face_count(); ++f) {
        faces_.push_back({solid.face_begin[at(f)], solid.face_begin[at(f) + 1], f});
    }
    centre_.setZero();
    radius_ = solid.radius;
}

bool ClippedSolid::cut(const Plane& plane, int tag) {
    if (clear_of(plane)) {
        return true;
    }
    if (!judge(plane)) {
        return !live_.empty();
    }
    cut_tag_ = tag;
    crossings_.clear();
    trimmed_faces_.clear();
    trimmed_half_edges_.clear();
    for (const Face& face : faces_) {
        trim_face(face);
    }
    close_hole(tag);
    faces_.swap(trimmed_faces_);
    half_edges_.swap(trimmed_half_edges_);
    // Both of each pair of buffers grow together, so that it does not matter which one the next pair starts
    // with.
    trimmed_faces_.reserve(faces_.capacity());
    trimmed_half_edges_.reserve(half_edges_.capacity());
    std::erase_if(live_, [this](int v) { return height_[at(v)] > 0; });
    for (const Crossing& c : crossings_) {
        live_.push_back(c.vertex);
    }
    bound();
    return !live_.empty();
}

bool ClippedSolid::clear_of(const Plane& plane) const {
    // The margin covers the rounding of this very test.
    return plane.normal.dot(centre_) - plane.offset < -radius_ * (1 + 1e-9);
}

// True when the plane has vertices on both sides. Leaves nothing when all are outside.
bool ClippedSolid::judge(const Plane& plane) {
    std::size_t outside = 0;
    for (const int v : live_) {
        const double h = plane.normal.dot(points_[at(v)]) - plane.offset;
        height_[at(v)] = h;
        outside += h > 0;
    }
    if (outside == live_.size()) {
        live_.clear();
        faces_.clear();
        half_edges_.clear();
    }
    return outside > 0 && !live_.empty();
}

void ClippedSolid::bound() {
    if (live_.empty()) {
        return;
    }
    Vec3 low = points_[at(live_.front())];
    Vec3 high = low;
    for (const int v : live_) {
        low = low.cwiseMin(points_[at(v)]);
        high = high.cwiseMax(points_[at(v)]);
    }
    centre_ = 0.5 * (low + high);
    radius_ = 0.5 * (high - low).norm();
}

// The number of the crossing on an edge. Both faces of the edge ask; the first one makes it, always from the
// inside end, so that the two agree to the last bit.
int ClippedSolid::crossing(int inside, int outside) {
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
        if (crossings_[i].inside == inside && crossings_[i].outside == outside) {
            return static_cast<int>(i);
        }
    }
    const double below = height_[at(inside)];
    const double share = below / (below - height_[at(outside)]);
    const Vec3 point = points_[at(inside)] + share * (points_[at(outside)] - points_[at(inside)]);
    const auto vertex = static_cast<int>(points_.size());
    points_.push_back(point);
    height_.push_back(0);
    crossings_.push_back({inside, outside, vertex, visited, 0});
    return static_cast<int>(crossings_.size()) - 1;
}

// Walks a face and drops its outside stretches. Each stretch leaves an edge from where the loop left to where
// it came back; the hole has the same edge the other way round.
void ClippedSolid::trim_face(const Face& face) {
    const auto begin = static_cast<int>(trimmed_half_edges_.size());
    int left_at = visited;     // the crossing where the present outside stretch began
    int entered_at = visited;  // the crossing that closes a stretch begun before the first vertex
    for (int e = face.begin; e < face.end; ++e) {
        const HalfEdge& edge = half_edges_[at(e)];
        const int next = half_edges_[at(e + 1 < face.end ? e + 1 : face.begin)].vertex;
        const bool here_inside = height_[at(edge.vertex)] <= 0;
        const bool next_inside = height_[at(next)] <= 0;
        if (here_inside) {
            trimmed_half_edges_.push_back(edge);
        }
        if (here_inside && !next_inside) {
            left_at = crossing(edge.vertex, next);
            trimmed_half_edges_.push_back({crossings_[at(left_at)].vertex, cut_tag_});
        } else if (!here_inside && next_inside) {
            const int back = crossing(next, edge.vertex);
            trimmed_half_edges_.push_back({crossings_[at(back)].vertex, edge.across});
            if (left_at == visited) {
                entered_at = back;
            } else {
                crossings_[at(back)].next = left_at;
                crossings_[at(back)].across = face.tag;
                left_at = visited;
            }
        }
    }
    if (entered_at != visited) {
        crossings_[at(entered_at)].next = left_at;
        crossings_[at(entered_at)].across = face.tag;
    }
    const auto end = static_cast<int>(trimmed_half_edges_.size());
    if (end > begin) {
        trimmed_faces_.push_back({begin, end, face.tag});
    }
}

// The crossings form closed loops: one, unless rounding bent a face across the plane more than once.
void ClippedSolid::close_hole(int tag) {
    for (Crossing& first : crossings_) {
        if (first.next == visited) {
            continue;
        }
        const auto begin = static_cast<int>(trimmed_half_edges_.size());
        for (Crossing* c = &first; c->next != visited;) {
            trimmed_half_edges_.push_back({c->vertex, c->across});
            Crossing* following = &crossings_[at(c->next)];
            c->next = visited;
            c = following;
        }
        trimmed_faces_.push_back({begin, static_cast<int>(trimmed_half_edges_.size()), tag});
    }
}

}  // namespace scree
