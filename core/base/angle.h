#pragma once

#include <compare>
#include <numbers>

namespace alidade {

/// A plane angle. Its value is in radians. Only `wrapped` reduces it by whole turns; otherwise 370° stays
/// 370°. Named factories and readers keep the unit visible where a number enters or leaves.
class Angle {
 public:
  constexpr Angle() = default;

  static constexpr Angle fromRadians(double radians) { return Angle(radians); }
  static constexpr Angle fromDegrees(double degrees) { return Angle(degrees * (std::numbers::pi / 180)); }
  static constexpr Angle fromArcseconds(double arcseconds) { return fromDegrees(arcseconds / 3600); }
  static constexpr Angle fromGon(double gon) { return fromDegrees(gon * 0.9); }

  constexpr double radians() const { return m_radians; }
  constexpr double degrees() const { return m_radians * (180 / std::numbers::pi); }
  constexpr double arcseconds() const { return degrees() * 3600; }

  constexpr Angle operator-() const { return Angle(-m_radians); }
  constexpr Angle operator+(Angle other) const { return Angle(m_radians + other.m_radians); }
  constexpr Angle operator-(Angle other) const { return Angle(m_radians - other.m_radians); }
  constexpr Angle operator*(double factor) const { return Angle(m_radians * factor); }
  constexpr auto operator<=>(const Angle&) const = default;

 private:
  explicit constexpr Angle(double radians) : m_radians(radians) {}

  double m_radians = 0;
};

/// The angle that differs from `angle` by whole turns and lies in [centre − 180°, centre + 180°). No other
/// function wraps angles. Use the centre 0° for differences, 180° for circle readings.
Angle wrapped(Angle angle, Angle centre = {});

/// Rounds to `decimals` (0…9) places of arcseconds, as `formatDms` does, then wraps: about 180°,
/// 359°59'59.9999" becomes 0 and is not written as 360°.
Angle wrappedAsWritten(Angle angle, int decimals, Angle centre);

/// The mean of directions. Unlike a mean of numbers it does not depend on where they are wrapped.
class MeanDirection {
 public:
  void add(Angle direction);
  /// In [−180°, 180°]; 0 without directions.
  Angle value() const;

 private:
  double m_cosine = 0, m_sine = 0;
};

}  // namespace alidade
