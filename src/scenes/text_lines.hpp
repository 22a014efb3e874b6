#pragma once

#include <sstream>
#include <string>
#include <vector>

#include <scree/scenes/simulation.hpp>

namespace scree {

using Lines = std::vector<std::string>;

inline std::string text(const Vec3& v) {
    std::ostringstream out;
    out << v.x() << ' ' << v.y() << ' ' << v.z();
    return out.str();
}

/// Writes a line and adds it.
class Line {
  public:
    explicit Line(Lines& lines) : lines_(lines) {}
    ~Line() { lines_.push_back(out_.str()); }
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;

    template <class T>
    Line& operator<<(const T& part) {
        out_ << part;
        return *this;
    }
    Line& operator<<(const Vec3& v) { return *this << text(v); }

  private:
    Lines& lines_;
    std::ostringstream out_;
};

// Lines about the bodies of a scene: how many and how heavy, how they move, and of what shapes they are.
void add_bodies(const Simulation& simulation, Lines& lines);
void add_motions(const Simulation& simulation, Lines& lines);
void add_shapes(const Simulation& simulation, Lines& lines);

}  // namespace scree
