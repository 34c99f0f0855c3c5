#include "ui/panels/parts/frames.h"

#include <QScrollArea>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

namespace alidade::ui {

namespace {

constexpr const char* setByHand = "isSetByHand";

class Scrolled : public QScrollArea {
 public:
  explicit Scrolled(QWidget* content) {
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setFocusPolicy(Qt::NoFocus);
    setWidget(content);
    content->setAutoFillBackground(false);
    viewport()->setAutoFillBackground(false);
  }

  QSize sizeHint() const override { return widget()->sizeHint(); }
  QSize minimumSizeHint() const override {
    return {0, std::min(widget()->minimumSizeHint().height(), 5 * fontMetrics().height())};
  }
};

}  // namespace

QSplitter* split(Qt::Orientation orientation, const char* name, std::initializer_list<QWidget*> parts,
                 const QList<int>& sizes) {
  auto* splitter = new QSplitter(orientation);
  splitter->setObjectName(QString::fromLatin1(name));
  splitter->setChildrenCollapsible(false);
  for (QWidget* part : parts) splitter->addWidget(part);
  splitter->setSizes(sizes);
  QObject::connect(splitter, &QSplitter::splitterMoved, splitter, [splitter] { markSetByHand(*splitter); });
  return splitter;
}

bool isSetByHand(const QSplitter& splitter) {
  return splitter.property(setByHand).toBool();
}

void markSetByHand(QSplitter& splitter) {
  splitter.setProperty(setByHand, true);
}

QWidget* padded(QWidget* content, const QMargins& margins) {
  auto* frame = new QWidget;
  auto* layout = new QVBoxLayout(frame);
  layout->setContentsMargins(margins);
  layout->addWidget(content);
  return frame;
}

QWidget* scrolled(QWidget* content) {
  return new Scrolled(content);
}

QWidget* stacked(QWidget* upper, QWidget* lower) {
  auto* stack = new QWidget;
  auto* layout = new QVBoxLayout(stack);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(upper);
  layout->addWidget(lower, 1);
  return stack;
}

}  // namespace alidade::ui
