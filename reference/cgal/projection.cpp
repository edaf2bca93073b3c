// The projection along a prism with exact constructions: lines and planes through its tets.
//
//   projection [--gmpq] [--sums]
//
// With EPECK, or with CGAL's Cartesian kernel on Gmpq. Reads batches: a line `projection N`, then N times 30 doubles, the
// points b0 b1 b2 m0 m1 m2 t0 t1 t2 of a prism whose corners are in ascending vertex order, and a point p. Answers N
// lines: a mask of the tets that hold p (bit k: the k-th of the six from below), then for every different image of p the
// weights on the three corners and the height, as decimal rationals; or `broken` if a chain does not reach the middle.
//
// With --sums images are sums of barycentric coordinates in the tet, quotients of volumes: fewer operations. A line
// `timed N` is `projection N` with a line `seconds=...` before the answers: the time until all images are known exactly,
// without their text.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <optional>

#include "serve.hpp"

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
      const int l = slab - 1, h = slab;
      add(slab, 2, {lo[0], lo[1], lo[2], hi[2]}, {0, 1, 2, 2}, {l, l, l, h});
      add(slab, 1, {lo[0], lo[1], hi[1], hi[2]}, {0, 1, 1, 2}, {l, l, h, h});
      add(slab, 0, {lo[0], hi[0], hi[1], hi[2]}, {0, 0, 1, 2}, {l, h, h, h});
    }
  }

  using Image = std::array<FT, 4>;

  struct Answer {
    unsigned mask = 0;
    bool broken = false;
    std::vector<Image> images;
  };

  Answer project(const Point& p, bool sums) const {
    Answer out;
    for (int i = 0; i < 6; ++i) {
      if (!tets_[i] || tets_[i]->solid.bounded_side(p) == CGAL::ON_UNBOUNDED_SIDE) continue;
      out.mask |= 1U << i;
      const std::optional<Image> image = sums ? by_sums(p, *tets_[i]) : chain(p, i);
      if (!image) {
        out.broken = true;
      } else if (std::find(out.images.begin(), out.images.end(), *image) == out.images.end()) {
        out.images.push_back(*image);
      }
    }
    return out;
  }

 private:
  struct Tet {
    typename Kernel::Tetrahedron_3 solid;
    Point lo, hi;                 // the ends of the pillar half that is an edge of it
    std::array<Point, 3> inner;   // the face towards the middle surface
    std::array<int, 4> corners;   // of the prism, and
    std::array<int, 4> heights;   // -1, 0, 1: where the solid's points are
  };

  // Leaves out the tets on a pinched pillar.
  void add(int slab, int pillar, const std::array<Point, 4>& points, const std::array<int, 4>& corners,
           std::array<int, 4> heights) {
    const Point &lo = at_[slab][pillar], &hi = at_[slab + 1][pillar];
    if (lo == hi) return tets_.push_back(std::nullopt);
    // A pinched vertex lies on the middle surface, whichever layer it is taken from.
    for (int i = 0; i < 4; ++i)
      if (at_[0][corners[i]] == at_[1][corners[i]] && at_[1][corners[i]] == at_[2][corners[i]]) heights[i] = 0;
    const Point& outer = slab == 0 ? lo : hi;
    std::vector<Point> face;
    for (const Point& q : points)
      if (q != outer) face.push_back(q);
    tets_.push_back(
        Tet{{points[0], points[1], points[2], points[3]}, lo, hi, {face[0], face[1], face[2]}, corners, heights});
  }

  // Follows the field from a tet that holds p to the middle surface.
  std::optional<Image> chain(Point p, int start) const {
    FT height = 0;
    const int step = start < 3 ? 1 : -1, end = start < 3 ? 3 : 2;
    for (int i = start; i != end; i += step) {
      if (!tets_[i]) continue;
      const Tet& tet = *tets_[i];
      const Vector field = tet.hi - tet.lo;
      const auto common = CGAL::intersection(typename Kernel::Line_3(p, field),
                                             typename Kernel::Plane_3(tet.inner[0], tet.inner[1], tet.inner[2]));
      const Point* next = common ? boost::get<Point>(&*common) : nullptr;
      if (!next) return std::nullopt;
      int axis = 0;
      while (axis < 2 && field[axis] == 0) ++axis;
      height -= ((*next)[axis] - p[axis]) / field[axis];
      p = *next;
    }
    const auto& m = at_[1];
    const Vector normal = CGAL::cross_product(m[1] - m[0], m[2] - m[0]);
    if (normal * (p - m[0]) != 0) return std::nullopt;
    const FT whole = normal * normal;
    Image out;
    for (int k = 0; k < 3; ++k)
      out[k] = CGAL::cross_product(m[(k + 1) % 3] - p, m[(k + 2) % 3] - p) * normal / whole;
    out[3] = height;
    return out;
  }

  std::optional<Image> by_sums(const Point& p, const Tet& tet) const {
    const auto x = [&](int i) { return tet.solid.vertex(i); };
    const FT whole = CGAL::determinant(x(1) - x(0), x(2) - x(0), x(3) - x(0));
    const std::array<FT, 4> parts{CGAL::determinant(x(1) - p, x(2) - p, x(3) - p), CGAL::determinant(p - x(0), x(2) - x(0), x(3) - x(0)),
                                  CGAL::determinant(x(1) - x(0), p - x(0), x(3) - x(0)),
                                  CGAL::determinant(x(1) - x(0), x(2) - x(0), p - x(0))};
    Image out{0, 0, 0, 0};
    for (int i = 0; i < 4; ++i) {
      const FT weight = parts[i] / whole;
      out[tet.corners[i]] += weight;
      if (tet.heights[i] > 0) out[3] += weight;
      if (tet.heights[i] < 0) out[3] -= weight;
    }
    return out;
  }

  std::array<std::array<Point, 3>, 3> at_;
  std::vector<std::optional<Tet>> tets_;
};

template <class Answer>
std::string text_of(const Answer& answer) {
  std::string out = std::to_string(answer.mask);
  for (const auto& image : answer.images)
    for (const auto& number : image) out += ' ' + text(number);
  return answer.broken ? out + " broken" : out;
}

// Lazy numbers are not known exactly before they are asked for.
void force(const CGAL::Gmpq&) {}
void force(const Epeck::FT& lazy) { lazy.exact(); }

template <class Kernel>
void answer(bool sums) {
  using Answer = typename Prism<Kernel>::Answer;
  for (std::string line; std::getline(std::cin, line); std::cout.flush()) {
    std::istringstream words(line);
    std::string name;
    std::size_t cases = 0;
    const bool fits = words >> name >> cases && cases >= 1 && cases <= 65536;
    if (!fits || (name != "projection" && name != "timed")) refuse("not a batch: " + line);
    std::vector<double> numbers(30 * cases);
    if (!std::cin.read(reinterpret_cast<char*>(numbers.data()), static_cast<long>(numbers.size() * sizeof(double))))
      refuse("a batch ends too early");
    std::vector<Answer> answers;
    answers.reserve(cases);
    Watch watch;
    for (std::size_t i = 0; i < cases; ++i) {
      const double* x = &numbers[30 * i];
      answers.push_back(Prism<Kernel>(x).project({x[27], x[28], x[29]}, sums));
      for (const auto& image : answers.back().images)
        for (const auto& number : image) force(number);
    }
    const double seconds = watch.lap();
    if (name == "timed") std::cout << "seconds=" << seconds << '\n';
    for (const Answer& answer : answers) std::cout << text_of(answer) << '\n';
  }
}

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  bool gmpq = false, sums = false;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--gmpq") {
      gmpq = true;
    } else if (option == "--sums") {
      sums = true;
    } else {
      refuse("usage: projection [--gmpq] [--sums]");
    }
  }
  if (gmpq) {
    answer<CGAL::Simple_cartesian<CGAL::Gmpq>>(sums);
  } else {
    answer<Epeck>(sums);
  }
}
