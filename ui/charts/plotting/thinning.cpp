#include "ui/charts/plotting/thinning.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "ui/charts/plotting/clipping.h"

namespace alidade::ui {
namespace {

constexpr std::size_t fewMarks = 5000, fewSticks = 1000;
constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

/// A mapping into the scene. All plots are upright or rotated, without perspective.
class Mapping {
 public:
  explicit Mapping(const QTransform& transform)
      : m_11(transform.m11()),
        m_12(transform.m12()),
        m_21(transform.m21()),
        m_22(transform.m22()),
        m_dx(transform.dx()),
        m_dy(transform.dy()) {}

  QPointF operator()(const QPointF& at) const {
    return {m_11 * at.x() + m_21 * at.y() + m_dx, m_12 * at.x() + m_22 * at.y() + m_dy};
  }

 private:
  double m_11, m_12, m_21, m_22, m_dx, m_dy;
};

/// A raster with one cell per kind at each place; each cell starts as `empty`.
template <typename Chosen>
class Cells {
 public:
  Cells(const Raster& raster, std::size_t kinds, const Chosen& empty)
      : m_left(raster.area.left()),
        m_top(raster.area.top()),
        m_perCell(1 / raster.cell),
        m_columns(countOf(raster.area.width())),
        m_rows(countOf(raster.area.height())),
        m_chosen(m_columns * m_rows * kinds, empty) {}

  /// The cell at this point, or the cell nearest to the point.
  Chosen& at(const QPointF& point, std::size_t kind) {
    const std::size_t column = indexOf(point.x() - m_left, m_columns);
    const std::size_t row = indexOf(point.y() - m_top, m_rows);
    return m_chosen[(kind * m_rows + row) * m_columns + column];
  }
  const std::vector<Chosen>& all() const { return m_chosen; }

 private:
  std::size_t countOf(double length) const {
    constexpr double most = 4000;
    return static_cast<std::size_t>(std::clamp(std::ceil(length * m_perCell), 1.0, most));
  }
  std::size_t indexOf(double offset, std::size_t count) const {
    const double index = offset * m_perCell;
    if (!(index > 0)) return 0;
    return index < static_cast<double>(count) ? static_cast<std::size_t>(index) : count - 1;
  }

  double m_left, m_top, m_perCell;
  std::size_t m_columns, m_rows;
  std::vector<Chosen> m_chosen;
};

/// The uppermost and the lowest mark: their indices, and their y, which grows downwards.
struct Extremes {
  std::uint32_t up = none, down = none;
  double top = std::numeric_limits<double>::infinity(), bottom = -top;
};

struct Longest {
  std::uint32_t index = none;
  double squaredLength = -1;
};

/// The eighth of a turn that contains the direction of a line: one of eight numbers, 0 to 7.
std::size_t eighthOf(const QLineF& line) {
  return (line.dx() > 0 ? 1U : 0U) + (line.dy() > 0 ? 2U : 0U) +
         (std::abs(line.dx()) > std::abs(line.dy()) ? 4U : 0U);
}

double squaredLengthOf(const QLineF& line) {
  return line.dx() * line.dx() + line.dy() * line.dy();
}

bool isInside(const QRectF& area, const QPointF& at) {
  return at.x() >= area.left() && at.x() <= area.right() && at.y() >= area.top() && at.y() <= area.bottom();
}

template <typename Value>
std::size_t kindsOf(const std::vector<Value>& values) {
  std::size_t kinds = 1;
  for (const Value& value : values) kinds = std::max(kinds, value.kind + 1);
  return kinds;
}

template <typename Value>
std::vector<Value> chosen(const std::vector<Value>& all, const std::vector<bool>& wanted) {
  std::vector<Value> values;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (wanted[i]) values.push_back(all[i]);
  return values;
}

}  // namespace

std::vector<PlacedMark> thinned(const std::vector<Mark>& marks, const QTransform& sceneFromAxes,
                                const Raster& raster) {
  const Mapping inScene(sceneFromAxes);
  const QRectF area = raster.area;
  std::vector<PlacedMark> placed;
  placed.reserve(marks.size());
  for (const Mark& mark : marks) {
    const QPointF at = inScene(mark.at) + mark.shift;
    if (isInside(area, at)) placed.push_back({at, mark.kind});
  }
  if (placed.size() <= fewMarks) return placed;
  Cells<Extremes> cells(raster, kindsOf(placed), {});
  for (std::uint32_t i = 0; i < placed.size(); ++i) {
    const auto& [at, kind] = placed[i];
    Extremes& cell = cells.at(at, kind);
    if (at.y() < cell.top) cell.up = i, cell.top = at.y();
    if (at.y() > cell.bottom) cell.down = i, cell.bottom = at.y();
  }
  std::vector<bool> wanted(placed.size());
  for (const Extremes& cell : cells.all())
    if (cell.up != none) wanted[cell.up] = wanted[cell.down] = true;
  return chosen(placed, wanted);
}

std::vector<Stick> thinned(const std::vector<Stick>& sticks, const QTransform& sceneFromAxes,
                           const Raster& raster) {
  const Mapping inScene(sceneFromAxes);
  const QRectF area = raster.area;
  std::vector<Stick> placed;
  placed.reserve(sticks.size());
  for (const Stick& stick : sticks) {
    const QLineF line(inScene(stick.line.p1()) + stick.shift, inScene(stick.line.p2()) + stick.shift);
    if (isInside(area, line.p1()) && isInside(area, line.p2()))
      placed.push_back({line, stick.kind});
    else if (const auto part = clipped(line, area))
      placed.push_back({*part, stick.kind});
  }
  if (placed.size() <= fewSticks) return placed;
  Cells<Longest> cells(raster, 8 * kindsOf(placed), {});
  for (std::uint32_t i = 0; i < placed.size(); ++i) {
    const QLineF& line = placed[i].line;
    Longest& cell = cells.at(line.p1(), 8 * placed[i].kind + eighthOf(line));
    const double squaredLength = squaredLengthOf(line);
    if (squaredLength > cell.squaredLength) cell = {i, squaredLength};
  }
  std::vector<bool> wanted(placed.size());
  for (const Longest& cell : cells.all())
    if (cell.index != none) wanted[cell.index] = true;
  return chosen(placed, wanted);
}

}  // namespace alidade::ui
