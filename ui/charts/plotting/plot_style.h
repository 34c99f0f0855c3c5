#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>

#include "ui/charts/plotting/marker.h"

namespace alidade::ui {

/// Colours, widths and type of a plot. All colours are opaque, so that screen and PDF/A agree.
struct PlotStyle {
  QColor background;
  QColor text;
  QColor mutedText;
  QColor frame;
  QColor grid;
  QColor upper;  ///< colour for the axis at 0°
  QColor lower;  ///< colour for the axis at 180°
  QColor excluded;
  QColor band;       ///< ±1σ
  QColor outerBand;  ///< ±1σ of the circle with the larger σ, if the σ of the circles differ
  QColor limit;      ///< ±3σ
  QFont font;        ///< with a pixel size, in scene units

  double unit() const { return font.pixelSize() / 11.0; }  ///< factor of line widths and marker sizes

  /// The colour for the axis at `axisDeg`, 0 or 180.
  QColor ofAxis(int axisDeg) const { return axisDeg == 0 ? upper : lower; }
  /// Filled at 0°, hollow at 180°, ringed for a repeat (`repeat` > 1).
  Marker marker(int axisDeg, MarkerShape shape, int repeat = 1) const;
  Marker excludedMarker() const;
};

/// Follows a widget's palette, light or dark.
PlotStyle screenStyle(const QPalette& palette, const QFont& font);

/// Black on white, for 96 scene units to the inch.
PlotStyle printStyle(const QString& fontFamily);

}  // namespace alidade::ui
