#pragma once

#include <QDialog>
#include <functional>

class QLabel;
class QPrinter;
class QPrintPreviewWidget;
class QToolBar;

namespace alidade::ui {

/// The choice of the user after the preview.
enum class PreviewAnswer { Close, Print, Export, Contents, Page };

/// The pages of a report as they are printed.
class PrintPreview : public QDialog {
  Q_OBJECT

 public:
  PrintPreview(QPrinter& printer, const std::function<void(QPrinter&)>& paint, QWidget* parent = nullptr);

  PreviewAnswer ask();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addActions(QToolBar& bar);
  void turn(int pages);
  void tellPage();

  QPrintPreviewWidget* m_view;
  QLabel* m_page;
  PreviewAnswer m_answer = PreviewAnswer::Close;
};

}  // namespace alidade::ui
