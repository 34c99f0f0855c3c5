// Wheel, mouse and keyboard on the charts, and the files of their menu.

#include <gtest/gtest.h>

#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QGraphicsView>
#include <QMenu>
#include <QPointer>
#include <QRubberBand>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <QXmlStreamReader>
#include <cmath>
#include <set>

#include "core/evaluation/evaluation.h"
#include "core/exchange/csv_table.h"
#include "tests/ui/support.h"
#include "ui/charts/arc/arc_chart.h"
#include "ui/charts/arc/arc_plot.h"
#include "ui/charts/plotting/caption.h"
#include "ui/charts/residuals/residual_chart.h"
#include "ui/charts/residuals/residual_plot.h"

namespace alidade::ui {
namespace {

QAction* actionOf(const QMenu& menu, const QString& text) {
  for (QAction* action : menu.actions()) {
    if (action->menu())
      if (QAction* found = actionOf(*action->menu(), text)) return found;
    if (action->text().remove(u'&').section(u'\t', 0, 0) == text) return action;
  }
  return nullptr;
}

template <typename Chart>
class PlotHands : public ::testing::Test {
 protected:
  PlotHands() {
    chart.resize(700, 500);
    chart.setEvaluation(evaluate(paperSession()));
    chart.show();
    QApplication::setActiveWindow(&chart);
    chart.setFocus();
  }

  Plot& plot() { return *chart.plot(); }
  QWidget* viewport() { return chart.template findChild<QGraphicsView*>()->viewport(); }
  QRectF shown() { return plot().sceneFromAxes().inverted().mapRect(plot().plotArea()); }
  QPointF axesAt(const QPointF& scene) { return plot().sceneFromAxes().inverted().map(scene); }

  void wheel(const QPointF& at, int notches) {
    QWheelEvent event(at, viewport()->mapToGlobal(at), {}, QPoint(0, 120 * notches), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(viewport(), &event);
  }
  void dragWith(Qt::MouseButton button, const QPoint& from, const QPoint& to,
                Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(viewport(), button, modifiers, from);
    for (const QPoint& at : {(from + to) / 2, to}) {
      QMouseEvent event(QEvent::MouseMove, at, viewport()->mapToGlobal(at), Qt::NoButton, button, modifiers);
      QApplication::sendEvent(viewport(), &event);
    }
    QTest::mouseRelease(viewport(), button, modifiers, to);
  }
  void choose(const QString& text) {
    const auto menu = chart.makeMenu();
    QAction* action = actionOf(*menu, text);
    ASSERT_TRUE(action) << text.toStdString();
    ASSERT_TRUE(action->isEnabled());
    action->trigger();
  }
  QByteArray saved(const QString& text) {
    QByteArray bytes;
    const auto connection = QObject::connect(&chart.files(), &ChartFiles::fileWanted, &chart,
                                             [&](const ChartFile& file) { bytes = file.bytes; });
    choose(text);
    QObject::disconnect(connection);
    return bytes;
  }

  Chart chart;
};
using AllPlots = ::testing::Types<ArcChart, ResidualChart>;
TYPED_TEST_SUITE(PlotHands, AllPlots);

TYPED_TEST(PlotHands, TheWheelEnlargesAboutThePointer) {
  const QRectF before = this->shown();
  const QPointF at = this->plot().plotArea().center() + QPointF(60, -40);
  const QPointF under = this->axesAt(at);
  this->wheel(at, 3);
  EXPECT_NEAR(this->shown().width(), before.width() / std::pow(1.25, 3), 0.02 * before.width());
  const QPointF now = this->axesAt(at);
  EXPECT_NEAR(now.x(), under.x(), 0.01 * before.width());
  EXPECT_NEAR(now.y(), under.y(), 0.01 * before.height());
  EXPECT_TRUE(this->plot().isZoomed());
  this->wheel(at, -4);
  EXPECT_FALSE(this->plot().isZoomed());
  EXPECT_EQ(this->shown(), before);
}

TYPED_TEST(PlotHands, ABandIsShownWhole) {
  const QRectF area = this->plot().plotArea();
  const QPoint from = (area.topLeft() + QPointF(80, 60)).toPoint(), to = from + QPoint(200, 120);
  const QPointF corners[] = {this->axesAt(from), this->axesAt(to)};
  this->dragWith(Qt::LeftButton, from, to);
  const QRectF slack = this->shown().adjusted(-1e-6, -1e-6, 1e-6, 1e-6);
  for (const QPointF& corner : corners) EXPECT_TRUE(slack.contains(corner));
  EXPECT_TRUE(this->plot().isZoomed());
  for (const auto* band : this->viewport()->template findChildren<QRubberBand*>())
    EXPECT_FALSE(band->isVisible());
  QTest::mouseDClick(this->viewport(), Qt::LeftButton, {}, from);
  EXPECT_FALSE(this->plot().isZoomed());
}

TYPED_TEST(PlotHands, AClickOnNothingAndASlipZoomNothing) {
  const QPoint at = (this->plot().plotArea().bottomLeft() + QPointF(5, -5)).toPoint();
  QTest::mouseClick(this->viewport(), Qt::LeftButton, {}, at);
  this->dragWith(Qt::LeftButton, at, at + QPoint(40, 1));
  EXPECT_FALSE(this->plot().isZoomed());
}

TYPED_TEST(PlotHands, WhatIsDraggedFollowsTheHand) {
  this->wheel(this->plot().plotArea().center(), 5);
  const QPoint from = this->plot().plotArea().center().toPoint(), by(30, -20);
  for (const auto& [button, modifiers] :
       {std::pair(Qt::MiddleButton, Qt::KeyboardModifiers()),
        std::pair(Qt::LeftButton, Qt::KeyboardModifiers(Qt::ShiftModifier))}) {
    const QPointF under = this->axesAt(from);
    this->dragWith(button, from, from + by, modifiers);
    const QPointF now = this->plot().sceneFromAxes().map(under);
    constexpr int slack = 8;  // the axis numbers may have become wider
    EXPECT_NEAR(now.x(), from.x() + by.x(), slack);
    EXPECT_NEAR(now.y(), from.y() + by.y(), slack);
  }
}

TYPED_TEST(PlotHands, KeysEnlargeMoveAndReset) {
  const QRectF before = this->shown();
  QTest::keyClick(&this->chart, Qt::Key_Plus);
  QTest::keyClick(&this->chart, Qt::Key_Plus);
  EXPECT_LT(this->shown().width(), 0.7 * before.width());
  const QRectF enlarged = this->shown();
  QTest::keyClick(&this->chart, Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_GT(this->shown().left(), enlarged.left());
  QTest::keyClick(&this->chart, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_GT(this->shown().top(), enlarged.top()) << "higher values are at its top";
  QTest::keyClick(&this->chart, Qt::Key_Minus);
  EXPECT_GT(this->shown().width(), enlarged.width());
  QTest::keyClick(&this->chart, Qt::Key_Home);
  EXPECT_EQ(this->shown(), before);
}

TYPED_TEST(PlotHands, ArrowsReachEveryPoint) {
  QSignalSpy stepped(&this->chart, &PlotWidget::sightingStepped);
  const std::size_t count = this->plot().markers().marks().size();
  std::set<std::size_t> reached;
  double x = -1e9;
  for (std::size_t i = 0; i < count; ++i) {
    QTest::keyClick(&this->chart, Qt::Key_Right);
    ASSERT_TRUE(this->plot().current());
    EXPECT_GE(this->plot().current()->at.x(), x);
    x = this->plot().current()->at.x();
    reached.insert(*this->plot().markers().current());
  }
  EXPECT_EQ(reached.size(), count);
  EXPECT_EQ(stepped.count(), static_cast<int>(count));
  double y = this->plot().current()->at.y();
  for (std::size_t i = 0; i < count; ++i) {
    QTest::keyClick(&this->chart, Qt::Key_Up);
    EXPECT_GE(this->plot().current()->at.y(), y);
    y = this->plot().current()->at.y();
  }
  for (const Mark& mark : this->plot().markers().marks()) EXPECT_LE(mark.at.y(), y);
}

TYPED_TEST(PlotHands, APointReachedIsInSightAndActivatedByEnter) {
  for (int i = 0; i < 12; ++i) QTest::keyClick(&this->chart, Qt::Key_Plus);
  for (int i = 0; i < 20; ++i) {
    QTest::keyClick(&this->chart, Qt::Key_Left);
    const Mark* mark = this->plot().current();
    EXPECT_TRUE(this->plot().plotArea().contains(this->plot().markers().scenePosition(*mark)));
  }
  QSignalSpy activated(&this->chart, &PlotWidget::sightingActivated);
  const SightingRef ref = this->plot().current()->ref;
  QTest::keyClick(&this->chart, Qt::Key_Return);
  ASSERT_EQ(activated.count(), 1);
  EXPECT_EQ(activated[0][0].template value<std::size_t>(), ref.position);
  EXPECT_EQ(activated[0][1].template value<std::size_t>(), ref.row);
  QTest::keyClick(&this->chart, Qt::Key_Escape);
  EXPECT_FALSE(this->plot().current());
}

TYPED_TEST(PlotHands, TellsTheCurrentPointToScreenReaders) {
  QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(&this->chart);
  ASSERT_TRUE(accessible);
  EXPECT_EQ(accessible->role(), QAccessible::Chart);
  EXPECT_EQ(accessible->text(QAccessible::Value), QString());
  EXPECT_FALSE(accessible->text(QAccessible::Name).isEmpty());
  EXPECT_EQ(accessible->text(QAccessible::Description), this->plot().summary());
  QTest::keyClick(&this->chart, Qt::Key_Right);
  EXPECT_EQ(accessible->text(QAccessible::Value), this->plot().describe(*this->plot().current()));
  EXPECT_TRUE(accessible->text(QAccessible::Value).contains(QStringLiteral("point ")));
}

TYPED_TEST(PlotHands, EveryPointHasWordsAPlaceAndARoleForScreenReaders) {
  QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(&this->chart);
  ASSERT_TRUE(accessible);
  const auto count = static_cast<int>(this->plot().markers().marks().size());
  const int parts = accessible->childCount() - count;
  ASSERT_GE(parts, 0);
  for (int i = 0; i < count; ++i) {
    QAccessibleInterface* point = accessible->child(parts + i);
    ASSERT_TRUE(point && point->isValid());
    EXPECT_EQ(point, accessible->child(parts + i)) << "one for each, not one for each call";
    EXPECT_EQ(point->role(), QAccessible::ListItem);
    EXPECT_EQ(point->parent(), accessible);
    EXPECT_EQ(accessible->indexOfChild(point), parts + i);
    const QString words = point->text(QAccessible::Name);
    EXPECT_TRUE(words.contains(QStringLiteral("point ")) && !words.contains(u'\n')) << words.toStdString();
    EXPECT_FALSE(point->state().focused);
  }
  QAccessibleInterface* first = accessible->child(parts);
  const QPoint middle = first->rect().center();
  QAccessibleInterface* there = accessible->childAt(middle.x(), middle.y());
  ASSERT_TRUE(there);
  EXPECT_EQ(there->role(), QAccessible::ListItem);
  QTest::keyClick(&this->chart, Qt::Key_Right);
  QAccessibleInterface* focused = accessible->focusChild();
  ASSERT_TRUE(focused);
  EXPECT_TRUE(focused->state().focused);
  EXPECT_EQ(focused->text(QAccessible::Name),
            this->chart.currentPoint().replace(u'\n', QStringLiteral(", ")));
  this->chart.setEvaluation({});
  EXPECT_FALSE(first->isValid()) << "its reading is gone";
  EXPECT_EQ(accessible->childCount(), parts);
}

TYPED_TEST(PlotHands, TheCurrentPointStaysWithItsReading) {
  for (int i = 0; i < 7; ++i) QTest::keyClick(&this->chart, Qt::Key_Right);
  const Mark before = *this->plot().current();
  Session session = paperSession();
  session.positions[0].readings[12].vertical = "81°29'30\"";
  this->chart.setEvaluation(evaluate(session));
  ASSERT_TRUE(this->plot().current());
  EXPECT_EQ(this->plot().current()->ref, before.ref);
  EXPECT_EQ(this->plot().current()->kind, before.kind);
  this->chart.setEvaluation({});
  EXPECT_FALSE(this->plot().current());
  QTest::keyClick(&this->chart, Qt::Key_Right);
  EXPECT_EQ(this->chart.currentPoint(), QString());
}

TYPED_TEST(PlotHands, SaysWhatAGoodOneLooksLike) {
  const auto* caption = this->chart.template findChild<Caption*>();
  ASSERT_TRUE(caption);
  EXPECT_TRUE(caption->sentence().startsWith(QStringLiteral("Should be: ")));
  EXPECT_EQ(caption->accessibleName(), caption->sentence());
  EXPECT_EQ(caption->text(), caption->sentence());
  this->chart.resize(340, 280);
  QApplication::processEvents();
  EXPECT_TRUE(caption->text().contains(u'\n'));
  EXPECT_EQ(QString(caption->text()).replace(u'\n', u' '), caption->sentence()) << "on two lines";
  EXPECT_GE(caption->height(), 2 * caption->fontMetrics().lineSpacing());
  EXPECT_EQ(caption->toolTip(), caption->sentence());
}

TEST(Caption, TakesTwoLinesAtMostAndOneWhereThereIsLittleRoom) {
  QWidget around;
  around.resize(1000, 100);
  Caption caption(&around);
  around.show();
  caption.setSentence(
      QStringLiteral("Should be: an even band about 0, two of three within it, hardly one beyond."));
  const auto lines = [&](int width) {
    caption.resize(width, caption.heightForWidth(width));
    return caption.text().count(u'\n') + 1;
  };
  EXPECT_EQ(lines(900), 1);
  EXPECT_EQ(lines(300), 2);
  EXPECT_EQ(QString(caption.text()).replace(u'\n', u' '), caption.sentence());
  const int high = caption.height();
  EXPECT_EQ(lines(120), 2);
  EXPECT_TRUE(caption.text().endsWith(u'…'));
  EXPECT_EQ(caption.height(), high) << "and no more";
  caption.setMaySpread(false);
  EXPECT_EQ(lines(300), 1);
  EXPECT_TRUE(caption.text().endsWith(u'…'));
  EXPECT_LT(caption.height(), high);
}

TYPED_TEST(PlotHands, SvgHoldsItsMarksAndTexts) {
  const QByteArray svg = this->saved(QStringLiteral("Save as SVG…"));
  QXmlStreamReader xml(svg);
  int shapes = 0;
  QString texts, title, description;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    const QString name = xml.name().toString();
    if (name == QStringLiteral("path") || name == QStringLiteral("circle") ||
        name == QStringLiteral("ellipse"))
      ++shapes;
    if (name == QStringLiteral("text"))
      texts += xml.readElementText(QXmlStreamReader::IncludeChildElements).remove(u' ');
    if (name == QStringLiteral("title")) title = xml.readElementText();
    if (name == QStringLiteral("desc")) description = xml.readElementText();
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  EXPECT_GE(shapes, static_cast<int>(this->plot().markers().marks().size()));
  EXPECT_EQ(title, this->chart.accessibleName());
  EXPECT_EQ(description, this->plot().summary());
  for (const LegendEntry& entry : this->plot().legend().entries())
    EXPECT_TRUE(texts.contains(QString(entry.text).remove(u' ')))
        << texts.toStdString() << entry.text.toStdString();
}

// SVG of this Qt version cannot clip, so lines are clipped before.
TYPED_TEST(PlotHands, ZoomedSvgDrawsNothingBesideItsFrame) {
  this->wheel(this->plot().plotArea().center() + QPointF(40, 90), 8);
  const QByteArray svg = this->saved(QStringLiteral("Save as SVG…"));
  QXmlStreamReader xml(svg);
  const QRectF area = this->plot().plotArea().adjusted(-12, -12, 12, 12);
  const QRectF legend = this->plot().legend().mapRectToScene(this->plot().legend().boundingRect());
  int lines = 0;
  QTransform matrix;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QStringLiteral("g")) {
      const QString text = xml.attributes().value(QStringLiteral("transform")).toString();
      const QStringList parts = text.section(u'(', 1).section(u')', 0, 0).split(u',');
      if (parts.size() == 6)
        matrix = QTransform(parts[0].toDouble(), parts[1].toDouble(), parts[2].toDouble(),
                            parts[3].toDouble(), parts[4].toDouble(), parts[5].toDouble());
    }
    if (xml.name() != QStringLiteral("polyline")) continue;
    for (const QString& pair :
         xml.attributes().value(QStringLiteral("points")).toString().split(u' ', Qt::SkipEmptyParts)) {
      const QPointF at =
          matrix.map(QPointF(pair.section(u',', 0, 0).toDouble(), pair.section(u',', 1, 1).toDouble()));
      if (legend.contains(at)) continue;
      EXPECT_TRUE(area.contains(at)) << at.x() << ", " << at.y();
      ++lines;
    }
  }
  EXPECT_GT(lines, 0);
}

TYPED_TEST(PlotHands, PngAndClipboardHaveTwoPixelsToAUnit) {
  const QImage image = QImage::fromData(this->saved(QStringLiteral("Save as PNG…")), "PNG");
  EXPECT_EQ(image.size(), this->viewport()->size() * 2);
  EXPECT_EQ(image.text(QStringLiteral("Title")), this->chart.accessibleName());
  EXPECT_EQ(image.pixelColor(1, image.height() - 2), this->plot().style().background);
  QApplication::clipboard()->clear();
  QTest::keyClick(&this->chart, Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(QApplication::clipboard()->image().size(), image.size());
}

TYPED_TEST(PlotHands, CsvHasARowForEveryPoint) {
  const QByteArray csv = this->saved(QStringLiteral("Save Numbers as CSV…"));
  const std::string text = csv.toStdString();
  CsvTable table(text);
  std::size_t rows = 0, cells = table.next()->cells.size();
  while (const auto row = table.next()) {
    EXPECT_EQ(row->cells.size(), cells);
    ++rows;
  }
  EXPECT_EQ(rows, this->plot().markers().marks().size());
}

// A file dialog runs an event loop within the menu's own call.
TYPED_TEST(PlotHands, ItsMenuOutlastsTheDialogsThatItOpens) {
  QContextMenuEvent byKey(QContextMenuEvent::Keyboard, QPoint(3, 3), this->chart.mapToGlobal(QPoint(3, 3)));
  QApplication::sendEvent(&this->chart, &byKey);
  QPointer<QMenu> menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_TRUE(menu);
  bool wasThere = false;
  QObject::connect(&this->chart.files(), &ChartFiles::fileWanted, &this->chart, [&] {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    wasThere = menu;
  });
  menu->setActiveAction(actionOf(*menu, QStringLiteral("Save as PNG…")));
  QTest::keyClick(menu, Qt::Key_Return);
  EXPECT_TRUE(wasThere);
}

TYPED_TEST(PlotHands, AMenuOpensByKeyAndButton) {
  QContextMenuEvent byKey(QContextMenuEvent::Keyboard, QPoint(3, 3), this->chart.mapToGlobal(QPoint(3, 3)));
  QApplication::sendEvent(&this->chart, &byKey);
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_TRUE(menu);
  EXPECT_TRUE(actionOf(*menu, QStringLiteral("Copy Picture")));
  menu->close();
  EXPECT_FALSE(QApplication::activePopupWidget());
}

}  // namespace
}  // namespace alidade::ui
