#include "ui/dialogs/print_preview.h"

#include <QAction>
#include <QLabel>
#include <QPrintPreviewWidget>
#include <QPrinter>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace alidade::ui {

PrintPreview::PrintPreview(QPrinter& printer, const std::function<void(QPrinter&)>& paint,
                           PreviewChange change, QWidget* parent)
    : QDialog(parent),
      m_change(std::move(change)),
      m_view(new QPrintPreviewWidget(&printer)),
      m_page(new QLabel) {
  setWindowTitle(tr("Print preview"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  resize(900, 720);
  auto* bar = new QToolBar;
  bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
  addActions(*bar);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(bar);
  layout->addWidget(m_view, 1);
  connect(m_view, &QPrintPreviewWidget::paintRequested, this, [paint](QPrinter* on) { paint(*on); });
  connect(m_view, &QPrintPreviewWidget::previewChanged, this, &PrintPreview::showPage);
}

void PrintPreview::addActions(QToolBar& bar) {
  const auto add = [&](const QString& text, const QKeySequence& keys, auto call) {
    QAction* action = bar.addAction(text, this, call);
    action->setShortcut(keys);
    action->setToolTip(
        keys.isEmpty() ? text : text + QStringLiteral(" (%1)").arg(keys.toString(QKeySequence::NativeText)));
  };
  const auto leave = [this](PreviewAnswer answer) {
    return [this, answer] {
      m_answer = answer;
      accept();
    };
  };
  add(tr("Print…"), QKeySequence::Print, leave(PreviewAnswer::Print));
  add(tr("Export…"), QKeySequence(tr("Ctrl+E")), leave(PreviewAnswer::Export));
  bar.addSeparator();
  const auto stay = [this](PreviewAnswer what) {
    return [this, what] {
      m_change(what);
      m_view->updatePreview();
    };
  };
  add(tr("Contents…"), {}, stay(PreviewAnswer::Contents));
  add(tr("Page Setup…"), {}, stay(PreviewAnswer::Page));
  bar.addSeparator();
  add(tr("Back"), QKeySequence(Qt::Key_PageUp), [this] { turn(-1); });
  bar.addWidget(m_page);
  m_page->setContentsMargins(6, 0, 6, 0);
  add(tr("Next"), QKeySequence(Qt::Key_PageDown), [this] { turn(1); });
  bar.addSeparator();
  add(tr("Whole Page"), QKeySequence(tr("Ctrl+0")), [this] { m_view->fitInView(); });
  add(tr("Width"), QKeySequence(tr("Ctrl+1")), [this] { m_view->fitToWidth(); });
  add(tr("Larger"), QKeySequence::ZoomIn, [this] { m_view->zoomIn(); });
  add(tr("Smaller"), QKeySequence::ZoomOut, [this] { m_view->zoomOut(); });
  bar.addSeparator();
  add(tr("Close"), {}, [this] { reject(); });
}

void PrintPreview::turn(int pages) {
  m_view->setCurrentPage(std::clamp(m_view->currentPage() + pages, 1, std::max(1, m_view->pageCount())));
  showPage();
}

void PrintPreview::showPage() {
  m_page->setText(tr("Page %1 of %2").arg(m_view->currentPage()).arg(m_view->pageCount()));
}

/// Fits the page now, since the view knows its size only once it is shown.
void PrintPreview::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  m_view->fitInView();
  m_view->setFocus();
}

PreviewAnswer PrintPreview::ask() {
  m_answer = PreviewAnswer::Close;
  exec();
  return m_answer;
}

}  // namespace alidade::ui
