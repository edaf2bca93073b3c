// Self-intersections of a mesh with CGAL.
//
//   embedded MESH.off
//
// Prints one line of key=value. `pairs`: pairs of triangles that share more than their common vertices (by index) force,
// by EPICK's intersection tests. `doubled`: triangles on the vertices of an earlier one; they share what their common
// vertices force and are no `pairs`. `pmp`: pairs by PMP::self_intersections, and `does` by PMP::does_self_intersect, 1 or
// 0; both are -1 for what is no Surface_mesh. `flat`: triangles without area; there nothing else is tested.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>

#include "off.hpp"

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const std::size_t*>;

struct Soup {
  std::vector<Point> points;
  std::vector<Face> faces;

  Kernel::Triangle_3 triangle(std::size_t f) const {
    return {points[faces[f][0]], points[faces[f][1]], points[faces[f][2]]};
  }

  // Do two triangles share more than their common vertices force?
  bool cross(std::size_t i, std::size_t j) const {
    Face f = faces[i], g = faces[j];
    // Common vertices first, in both.
    std::size_t common = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = std::find(g.begin() + static_cast<long>(common), g.end(), f[k]);
      if (at == g.end()) continue;
      std::swap(f[common], f[k]);
      std::iter_swap(g.begin() + static_cast<long>(common), at);
      ++common;
    }
    const auto edge = [&](const Face& h) { return Kernel::Segment_3(points[h[1]], points[h[2]]); };
    switch (common) {
      case 0: return CGAL::do_intersect(triangle(i), triangle(j));
      case 1: return CGAL::do_intersect(edge(f), triangle(j)) || CGAL::do_intersect(edge(g), triangle(i));
      case 2: {
        const Point &a = points[f[0]], &b = points[f[1]], &c = points[f[2]], &d = points[g[2]];
        return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
      }
      default: return false;
    }
  }

  std::size_t crossings() const {
    std::vector<std::size_t> ids(faces.size());
    std::iota(ids.begin(), ids.end(), 0);
    std::vector<Box> boxes;
    for (const std::size_t& i : ids) boxes.emplace_back(triangle(i).bbox(), &i);
    std::size_t pairs = 0;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                  [&](const Box& a, const Box& b) { pairs += cross(*a.handle(), *b.handle()); });
    return pairs;
  }

  std::size_t doubled() const {
    std::set<Face> seen;
    std::size_t count = 0;
    for (Face f : faces) {
      std::sort(f.begin(), f.end());
      count += !seen.insert(f).second;
    }
    return count;
  }

  std::optional<Surface> surface() const {
    Surface out;
    for (const Point& p : points) out.add_vertex(p);
    for (const Face& f : faces) {
      const auto vertex = [&](int i) { return Surface::Vertex_index(static_cast<Surface::size_type>(f[i])); };
      if (out.add_face(vertex(0), vertex(1), vertex(2)) == Surface::null_face()) return std::nullopt;
    }
    return out;
  }
};

int main(int argc, char** argv) {
  if (argc != 2) refuse("usage: embedded MESH.off");
  const Mesh mesh = read_off(argv[1]);
  Soup soup{{}, mesh.faces};
  for (const Row& row : mesh.points) soup.points.emplace_back(row[0], row[1], row[2]);
  std::size_t flat = 0;
  for (const Face& f : soup.faces) flat += CGAL::collinear(soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]);
  if (flat > 0) {
    std::cout << "flat=" << flat << '\n';
    return 0;
  }
  long pmp = -1, does = -1;
  if (const auto surface = soup.surface()) {
    std::vector<std::pair<Surface::Face_index, Surface::Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(*surface, std::back_inserter(pairs));
    pmp = static_cast<long>(pairs.size());
    does = CGAL::Polygon_mesh_processing::does_self_intersect(*surface);
  }
  std::cout << "flat=0 doubled=" << soup.doubled() << " pairs=" << soup.crossings() << " pmp=" << pmp << " does=" << does << '\n';
}
