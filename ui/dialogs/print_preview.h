#pragma once

#include <QDialog>
#include <functional>

class QLabel;
class QPrinter;
class QPrintPreviewWidget;
class QToolBar;

namespace alidade::ui {

/// The user's choice in the preview: `Contents` and `Page` change the preview, the others close it.
enum class PreviewAnswer { Close, Print, Export, Contents, Page };

/// Asks for the new contents or page set-up of the preview.
using PreviewChange = std::function<void(PreviewAnswer)>;

/// Shows the pages of a report as printed. Stays open while the user changes contents or page set-up.
class PrintPreview : public QDialog {
  Q_OBJECT

 public:
  PrintPreview(QPrinter& printer, const std::function<void(QPrinter&)>& paint, PreviewChange change,
               QWidget* parent = nullptr);

  PreviewAnswer ask();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addActions(QToolBar& bar);
  void turn(int pages);
  void showPage();

  PreviewChange m_change;
  QPrintPreviewWidget* m_view;
  QLabel* m_page;
  PreviewAnswer m_answer = PreviewAnswer::Close;
};

}  // namespace alidade::ui
