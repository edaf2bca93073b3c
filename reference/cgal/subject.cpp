// CGAL as a subject of docs/SUBJECTS.md, in text and in binary mode. Built three times: subject_epick (exact predicates,
// inexact constructions), subject_epeck (exact constructions), and subject_double (Cartesian kernel on plain doubles, a
// control that has to be found wrong).
//
// A line of two words, `NAME N`, begins a binary batch; any other line is a case of text mode.
// One more predicate than the page lists: `triangle_tet` (21 doubles, the triangle, then the tet): 1 if they share a point.
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>

#include "dot.hpp"
#include "tets.hpp"

#ifdef SUBJECT_EPECK
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
#elif defined(SUBJECT_DOUBLE)
#include <CGAL/Simple_cartesian.h>
using Kernel = CGAL::Simple_cartesian<double>;
#else
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
#endif
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Segment = Kernel::Segment_3;
using Tetrahedron = Kernel::Tetrahedron_3;

constexpr int UNSUPPORTED = 3;

// A case: its coordinates, read as points.
struct Case {
  const double* x;
  Kernel::Point_2 plane(int i) const { return {x[2 * i], x[2 * i + 1]}; }
  Point at(int i) const { return {x[3 * i], x[3 * i + 1], x[3 * i + 2]}; }
  // CGAL's intersection tests require triangles with area.
  std::optional<Triangle> triangle(int i) const {
    const Point a = at(i), b = at(i + 1), c = at(i + 2);
    if (CGAL::collinear(a, b, c)) return std::nullopt;
    return Triangle(a, b, c);
  }
};

bool on_segment(const Point& p, const Point& a, const Point& b) { return a == b ? p == a : Segment(a, b).has_on(p); }

bool in_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  if (CGAL::collinear(a, b, c)) return on_segment(p, a, b) || on_segment(p, b, c) || on_segment(p, c, a);
  return Triangle(a, b, c).has_on(p);
}

int orient2d(const Case& q) { return CGAL::orientation(q.plane(0), q.plane(1), q.plane(2)); }
int orient3d(const Case& q) { return CGAL::orientation(q.at(0), q.at(1), q.at(2), q.at(3)); }
int incircle(const Case& q) {
  return CGAL::side_of_oriented_circle(q.plane(0), q.plane(1), q.plane(2), q.plane(3));
}
int insphere(const Case& q) {
  return CGAL::side_of_oriented_sphere(q.at(0), q.at(1), q.at(2), q.at(3), q.at(4));
}
int dot_sign(const Case& q) { return DotOf<Kernel>::type()(q.at(0), q.at(1), q.at(2), q.at(3), q.at(4)); }

int point_in_tet(const Case& q) {
  const Point a = q.at(0), b = q.at(1), c = q.at(2), d = q.at(3), p = q.at(4);
  if (CGAL::orientation(a, b, c, d) != CGAL::COPLANAR) return Tetrahedron(a, b, c, d).bounded_side(p);
  const bool on = in_triangle(p, b, c, d) || in_triangle(p, a, c, d) || in_triangle(p, a, b, d) || in_triangle(p, a, b, c);
  return on ? 0 : -1;
}

int triangle_triangle(const Case& q) {
  const auto first = q.triangle(0), second = q.triangle(3);
  return first && second ? CGAL::do_intersect(*first, *second) : UNSUPPORTED;
}

int segment_triangle(const Case& q) {
  const auto triangle = q.triangle(2);
  return triangle && q.at(0) != q.at(1) ? CGAL::do_intersect(Segment(q.at(0), q.at(1)), *triangle) : UNSUPPORTED;
}

int ray_triangle(const Case& q) {
  const auto triangle = q.triangle(2);
  return triangle && q.at(0) != q.at(1) ? CGAL::do_intersect(Kernel::Ray_3(q.at(0), q.at(1)), *triangle) : UNSUPPORTED;
}

int triangle_tet(const Case& q) {
  const auto triangle = q.triangle(0);
  const Tetrahedron tet(q.at(3), q.at(4), q.at(5), q.at(6));
  return triangle && !tet.is_degenerate() ? CGAL::do_intersect(*triangle, tet) : UNSUPPORTED;
}

int prism_positivity(const Case& q) {
  // The bottom slab of a prism: layers 0 and 1.
  static const std::vector<LocalTet> tets = prism_tets();
  int least = 1;
  for (const LocalTet& tet : tets) {
    const auto in_slab = [](const Local& v) { return v.layer < 2; };
    if (!std::all_of(tet.begin(), tet.end(), in_slab)) continue;
    const auto at = [&](int i) { return q.at(3 * tet[i].layer + tet[i].corner); };
    least = std::min<int>(least, CGAL::orientation(at(0), at(1), at(2), at(3)));
  }
  return least;
}

int section_dot(const Case& q) {
  const DotOf<Kernel>::type dot;
  int least = 1;
  for (int i = 0; i < 3; ++i)
    least = std::min<int>(least, dot(q.at(0), q.at(1), q.at(2), q.at(3 + i), q.at(6 + i)));
  return least;
}

struct Predicate {
  std::size_t arity;
  int (*answer)(const Case&);
};

const std::map<std::string, Predicate> PREDICATES{
    {"orient2d", {6, orient2d}},
    {"orient3d", {12, orient3d}},
    {"incircle", {8, incircle}},
    {"insphere", {15, insphere}},
    {"dot_sign", {15, dot_sign}},
    {"point_in_tet", {15, point_in_tet}},
    {"triangle_triangle", {18, triangle_triangle}},
    {"segment_triangle", {15, segment_triangle}},
    {"ray_triangle", {15, ray_triangle}},
    {"triangle_tet", {21, triangle_tet}},
    {"prism_positivity", {18, prism_positivity}},
    {"section_dot", {27, section_dot}},
};

// One line of standard input without its end; false at the end of input.
bool read_line(std::string& line) {
  line.clear();
  for (int c; (c = std::getchar()) != EOF;) {
    if (c == '\n') return true;
    line.push_back(static_cast<char>(c));
  }
  return !line.empty();
}

void batch(const std::string& name, const std::string& count) {
  const auto found = PREDICATES.find(name);
  if (found == PREDICATES.end()) refuse("no predicate " + name);
  char* end = nullptr;
  const unsigned long long cases = std::strtoull(count.c_str(), &end, 10);
  if (*end != '\0' || cases < 1 || cases > 65536) refuse("not a batch: " + name + " " + count);
  const auto& [arity, answer] = found->second;
  std::vector<double> numbers(cases * arity);
  if (std::fread(numbers.data(), sizeof(double), numbers.size(), stdin) != numbers.size())
    refuse("a batch ends too early");
  std::vector<std::int8_t> answers;
  for (std::size_t i = 0; i < cases; ++i)
    answers.push_back(static_cast<std::int8_t>(answer(Case{&numbers[i * arity]})));
  std::fwrite(answers.data(), 1, answers.size(), stdout);
}

void line_case(std::istringstream& words, const std::string& name) {
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (*end != '\0' || !std::isfinite(numbers.back())) refuse("not a finite number: " + word);
  }
  const auto found = PREDICATES.find(name);
  int sign = UNSUPPORTED;
  if (found != PREDICATES.end()) {
    if (numbers.size() != found->second.arity) refuse(name + ": a wrong number of coordinates");
    sign = found->second.answer(Case{numbers.data()});
  }
  if (sign == UNSUPPORTED) {
    std::puts("unsupported");
  } else {
    std::printf("%d\n", sign);
  }
}

int main() {
  for (std::string line; read_line(line); std::fflush(stdout)) {
    std::istringstream words(line);
    std::string name, second, third;
    words >> name >> second;
    if (!(words >> third)) {
      batch(name, second);
    } else {
      std::istringstream again(line);
      again >> name;
      line_case(again, name);
    }
  }
}
