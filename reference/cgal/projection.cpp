// The projection along a prism with exact constructions: lines and planes through its tets.
//
//   projection [--gmpq]
//
// With EPECK, or with CGAL's Cartesian kernel on Gmpq. Reads batches: a line `projection N`, then N times 30 doubles, the
// points b0 b1 b2 m0 m1 m2 t0 t1 t2 of a prism whose corners are in ascending vertex order, and a point p. Answers N
// lines: a mask of the tets that hold p (bit k: the k-th of the six from below), then for every different image of p the
// weights on the three corners and the height, as decimal rationals; or `broken` if a chain does not reach the middle.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <cstdio>
#include <optional>

#include "off.hpp"

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

template <class Integer>
std::string text(const Integer& numerator, const Integer& denominator) {
  std::ostringstream out;
  out << numerator;
  if (denominator != 1) out << '/' << denominator;
  return out.str();
}

template <class Number>
std::string text(const Number& exact) {
  using Traits = CGAL::Fraction_traits<Number>;
  typename Traits::Numerator_type numerator;
  typename Traits::Denominator_type denominator;
  typename Traits::Decompose()(exact, numerator, denominator);
  return text(numerator, denominator);
}

std::string text(const Epeck::FT& lazy) { return text(lazy.exact()); }

template <class Kernel>
class Prism {
 public:
  using Point = typename Kernel::Point_3;
  using Vector = typename Kernel::Vector_3;
  using FT = typename Kernel::FT;

  explicit Prism(const double* x) {
    for (int layer = 0; layer < 3; ++layer)
      for (int k = 0; k < 3; ++k, x += 3) at_[layer][k] = Point(x[0], x[1], x[2]);
    for (int slab = 0; slab < 2; ++slab) {
      const auto &lo = at_[slab], &hi = at_[slab + 1];
      add(slab, 2, {lo[0], lo[1], lo[2], hi[2]});
      add(slab, 1, {lo[0], lo[1], hi[1], hi[2]});
      add(slab, 0, {lo[0], hi[0], hi[1], hi[2]});
    }
  }

  std::string project(const Point& p) const {
    unsigned mask = 0;
    std::vector<std::string> images;
    for (int i = 0; i < 6; ++i) {
      if (!tets_[i] || tets_[i]->solid.bounded_side(p) == CGAL::ON_UNBOUNDED_SIDE) continue;
      mask |= 1U << i;
      const std::string image = chain(p, i);
      if (std::find(images.begin(), images.end(), image) == images.end()) images.push_back(image);
    }
    std::string out = std::to_string(mask);
    for (const std::string& image : images) out += ' ' + image;
    return out;
  }

 private:
  struct Tet {
    typename Kernel::Tetrahedron_3 solid;
    Point lo, hi;                    // the ends of the pillar half that is an edge of it
    typename Kernel::Plane_3 inner;  // of the face towards the middle surface
  };

  // Leaves out the tets on a pinched pillar.
  void add(int slab, int pillar, const std::array<Point, 4>& points) {
    const Point &lo = at_[slab][pillar], &hi = at_[slab + 1][pillar];
    if (lo == hi) return tets_.push_back(std::nullopt);
    const Point& outer = slab == 0 ? lo : hi;
    std::vector<Point> face;
    for (const Point& q : points)
      if (q != outer) face.push_back(q);
    tets_.push_back(Tet{{points[0], points[1], points[2], points[3]}, lo, hi, {face[0], face[1], face[2]}});
  }

  // Follows the field from a tet that holds p to the middle surface.
  std::string chain(Point p, int start) const {
    FT height = 0;
    const int step = start < 3 ? 1 : -1, end = start < 3 ? 3 : 2;
    for (int i = start; i != end; i += step) {
      if (!tets_[i]) continue;
      const Tet& tet = *tets_[i];
      const Vector field = tet.hi - tet.lo;
      const auto common = CGAL::intersection(typename Kernel::Line_3(p, field), tet.inner);
      const Point* next = common ? boost::get<Point>(&*common) : nullptr;
      if (!next) return "broken";
      int axis = 0;
      while (axis < 2 && field[axis] == 0) ++axis;
      height -= ((*next)[axis] - p[axis]) / field[axis];
      p = *next;
    }
    const auto& m = at_[1];
    const Vector normal = CGAL::cross_product(m[1] - m[0], m[2] - m[0]);
    if (normal * (p - m[0]) != 0) return "broken";
    const FT whole = normal * normal;
    std::string out;
    for (int k = 0; k < 3; ++k)
      out += text(FT(CGAL::cross_product(m[(k + 1) % 3] - p, m[(k + 2) % 3] - p) * normal / whole)) + ' ';
    return out + text(height);
  }

  std::array<std::array<Point, 3>, 3> at_;
  std::vector<std::optional<Tet>> tets_;
};

template <class Kernel>
void answer() {
  for (std::string line; std::getline(std::cin, line); std::cout.flush()) {
    std::istringstream words(line);
    std::string name;
    std::size_t cases = 0;
    if (!(words >> name >> cases) || name != "projection" || cases < 1 || cases > 65536) refuse("not a batch: " + line);
    std::vector<double> numbers(30 * cases);
    if (!std::cin.read(reinterpret_cast<char*>(numbers.data()), static_cast<long>(numbers.size() * sizeof(double))))
      refuse("a batch ends too early");
    for (std::size_t i = 0; i < cases; ++i) {
      const double* x = &numbers[30 * i];
      std::cout << Prism<Kernel>(x).project({x[27], x[28], x[29]}) << '\n';
    }
  }
}

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  const bool gmpq = argc == 2 && std::string(argv[1]) == "--gmpq";
  if (argc > 1 && !gmpq) refuse("usage: projection [--gmpq]");
  if (gmpq) {
    answer<CGAL::Simple_cartesian<CGAL::Gmpq>>();
  } else {
    answer<Epeck>();
  }
}
