#include "ui/settings/theme.h"

#include <QApplication>
#include <QCursor>
#include <QEvent>
#include <QFont>
#include <QLabel>
#include <QPainter>
#include <QPixmapCache>
#include <QProxyStyle>
#include <QSettings>
#include <QStyleOption>
#include <QTabWidget>
#include <QToolTip>
#include <cmath>

#include "core/base/version.h"

void initializeAlidadeResources() {
  Q_INIT_RESOURCE(alidade);
}

namespace alidade::ui {

namespace {

const QString themeKey = QStringLiteral("theme");

QPalette& desktopPalette() {
  static QPalette palette;
  return palette;
}

QPalette paletteOf(const char* window, const char* base, const char* alternate, const char* button,
                   const char* text, const char* dim, const char* highlight, const char* highlightedText,
                   const char* link) {
  const auto color = [](const char* name) { return QColor(QString::fromLatin1(name)); };
  QPalette palette(color(button), color(window));
  palette.setColor(QPalette::Base, color(base));
  palette.setColor(QPalette::AlternateBase, color(alternate));
  palette.setColor(QPalette::ToolTipBase, color(base));
  for (const auto role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    palette.setColor(role, color(text));
    palette.setColor(QPalette::Disabled, role, color(dim));
  }
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::Light, color(button).lighter(112));
  palette.setColor(QPalette::Midlight, color(button).lighter(106));
  palette.setColor(QPalette::PlaceholderText, color(dim));
  palette.setColor(QPalette::Highlight, color(highlight));
  palette.setColor(QPalette::HighlightedText, color(highlightedText));
  palette.setColor(QPalette::Disabled, QPalette::Highlight, color(dim));
  palette.setColor(QPalette::Link, color(link));
  return palette;
}

QPalette lightPalette() {
  return paletteOf("#f0f1f3", "#ffffff", "#f6f7f9", "#e9ebee", "#1d2329", "#6b7480", "#2f6db3", "#ffffff",
                   "#1f5fa8");
}

QPalette darkPalette() {
  return paletteOf("#24282d", "#1b1e22", "#20242a", "#30353c", "#e4e7eb", "#98a1ac", "#3a76b8", "#ffffff",
                   "#7fb2ec");
}

/// Wraps the lines of a wide tool tip.
class TipShaper : public QObject {
 public:
  using QObject::QObject;

  bool eventFilter(QObject* watched, QEvent* event) override {
    constexpr int widest = 420;
    auto* tip = static_cast<QLabel*>(watched);
    const bool isSized = event->type() == QEvent::Show || event->type() == QEvent::Resize;
    if (!isSized || tip->width() <= widest || tip->wordWrap()) return false;
    tip->setWordWrap(true);
    tip->resize(widest, tip->heightForWidth(widest));
    // The unwrapped tip may have been moved away from the pointer, to stay on the screen.
    const int pointer = QCursor::pos().x();
    if (pointer > tip->geometry().right()) tip->move(pointer - widest, tip->y());
    return false;
  }
};

/// Fusion without the light line above a tool bar, which glares on dark colours. In dark colours the frames
/// of check boxes are lighter, since Fusion draws them darker than the window.
class WorkstationStyle : public QProxyStyle {
 public:
  WorkstationStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

  using QProxyStyle::polish;

  /// All labels, including those of message boxes and tool tips, show plain text unless markup is explicitly
  /// enabled, so a name cannot act as markup.
  void polish(QWidget* widget) override {
    QProxyStyle::polish(widget);
    auto* label = qobject_cast<QLabel*>(widget);
    if (label && label->textFormat() == Qt::AutoText) label->setTextFormat(Qt::PlainText);
    if (label && label->inherits("QTipLabel")) label->installEventFilter(&m_tips);
  }

  /// Message boxes use the program's own icons.
  QIcon standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override {
    switch (which) {
      case SP_MessageBoxInformation:
        return themeIcon(QStringLiteral("note"));
      case SP_MessageBoxQuestion:
        return themeIcon(QStringLiteral("undecided"));
      case SP_MessageBoxWarning:
        return themeIcon(QStringLiteral("warning"));
      case SP_MessageBoxCritical:
        return themeIcon(QStringLiteral("problem"));
      default:
        return QProxyStyle::standardIcon(which, option, widget);
    }
  }

  /// Dialog buttons show text only.
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    return hint == SH_DialogButtonBox_ButtonsHaveIcons ? 0
                                                       : QProxyStyle::styleHint(hint, option, widget, data);
  }

  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override {
    if (element != CE_ToolBar) return QProxyStyle::drawControl(element, option, painter, widget);
    const QRect& bar = option->rect;
    painter->fillRect(bar, option->palette.window());
    painter->fillRect(bar.left(), bar.bottom(), bar.width(), 1, option->palette.mid());
  }

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    const auto* box = qstyleoption_cast<const QStyleOptionButton*>(option);
    if (element != PE_IndicatorCheckBox || !box || !isDark(option->palette))
      return QProxyStyle::drawPrimitive(element, option, painter, widget);
    QStyleOptionButton framed = *box;
    framed.palette.setColor(QPalette::Window, option->palette.color(QPalette::PlaceholderText));
    QProxyStyle::drawPrimitive(element, &framed, painter, widget);
  }

 private:
  TipShaper m_tips;
};

}  // namespace

void setUpApplication(QApplication& application) {
  initializeAlidadeResources();
  QApplication::setOrganizationName(QStringLiteral("Alidade"));
  QApplication::setApplicationName(QStringLiteral("alidade"));
  QApplication::setApplicationDisplayName(QStringLiteral("Alidade"));
  QApplication::setApplicationVersion(QString::fromStdString(versionAndBuild()));
  QApplication::setWindowIcon(themeIcon(QStringLiteral("alidade")));
  desktopPalette() = application.palette();
  QApplication::setStyle(new WorkstationStyle);
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPointSizeF(9.5);
  QApplication::setFont(font);
}

void applyTheme(Theme theme) {
  const bool dark = theme == Theme::Dark || (theme == Theme::System && isDark(desktopPalette()));
  const QPalette palette = dark ? darkPalette() : lightPalette();
  QPixmapCache::clear();  // the cache has disabled icons in the old colours
  QApplication::setPalette(palette);
  QToolTip::setPalette(palette);
  QSettings().setValue(themeKey, static_cast<int>(theme));
}

Theme rememberedTheme() {
  const int stored = QSettings().value(themeKey, 0).toInt();
  return stored == 1 ? Theme::Light : stored == 2 ? Theme::Dark : Theme::System;
}

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128;
}

QColor stateColor(const QPalette& palette, State state) {
  const bool dark = isDark(palette);
  switch (state) {
    case State::Good:
      return dark ? QColor(0x6f, 0xcf, 0x8b) : QColor(0x1b, 0x74, 0x3a);
    case State::Bad:
      return dark ? QColor(0xff, 0x8a, 0x80) : QColor(0xb8, 0x26, 0x1c);
    case State::Open:
      return dark ? QColor(0xf0, 0xb8, 0x5a) : QColor(0x8a, 0x5a, 0x00);
    case State::Quiet:
      break;
  }
  return palette.color(QPalette::PlaceholderText);
}

QColor mixed(const QColor& a, const QColor& b, double shareOfB) {
  const auto mix = [&](int from, int to) {
    return static_cast<int>(std::lround(from + (to - from) * shareOfB));
  };
  return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

QColor stateTint(const QPalette& palette, State state) {
  return mixed(palette.color(QPalette::Base), stateColor(palette, state), 0.16);
}

QIcon themeIcon(const QString& name) {
  return QIcon(QStringLiteral(":/icons/%1.svg").arg(name));
}

void markTab(QTabWidget& tabs, int tab, bool wrong) {
  const bool marked = !tabs.tabIcon(tab).isNull();
  if (marked != wrong) tabs.setTabIcon(tab, wrong ? themeIcon(QStringLiteral("problem")) : QIcon());
}

}  // namespace alidade::ui
