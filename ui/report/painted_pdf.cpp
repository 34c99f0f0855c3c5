#include "ui/report/painted_pdf.h"

#include <QBuffer>
#include <QPdfWriter>

namespace alidade::ui {

std::optional<std::string> paintedPdf(const ReportPaper& paper,
                                      const std::function<bool(QPagedPaintDevice& device)>& paint) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);
    writer.setResolution(1200);
    writer.setPageLayout(paper.layout());
    if (!paint(writer)) return std::nullopt;
  }
  return buffer.data().toStdString();
}

}  // namespace alidade::ui
