#include "ui/report/report_sheet.h"

#include <gtest/gtest.h>

#include <QBuffer>
#include <QPdfWriter>
#include <QPrinter>
#include <QTextLayout>

#include "ui/report/report_paper.h"

// The line breaks of texts of any length.

namespace alidade::ui {
namespace {

class ReportSheetTest : public testing::Test {
 protected:
  ReportSheetTest() {
    m_buffer.open(QIODevice::WriteOnly);
    m_writer.setResolution(1200);
    m_writer.setPageLayout(ReportPaper().layout());
  }

  ReportSheet sheet() { return ReportSheet(m_writer, {}, ReportPaper().margins); }

  /// Returns the lines into which Qt breaks the whole text at once.
  QStringList atOnce(const QString& text) {
    const double unit = m_writer.logicalDpiX() / 25.4;
    QStringList lines;
    QTextLayout layout(text, type::body.font(), &m_writer);
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
      line.setLineWidth(ReportSheet::width * unit);
      lines.append(text.mid(line.textStart(), line.textLength()).trimmed());
    }
    layout.endLayout();
    return lines;
  }

 private:
  QBuffer m_buffer;
  QPdfWriter m_writer{&m_buffer};
};

/// Words of every length up to twenty letters, filling `length` characters.
QString words(qsizetype length, QChar letter) {
  QString text;
  for (int word = 1; text.size() < length; ++word) text += QString(word * 7 % 20 + 1, letter) + u' ';
  return text.left(length).trimmed();
}

TEST(ReportPaper, IsTheFullPageOfAPrinter) {
  QPrinter printer(QPrinter::HighResolution);
  printer.setOutputFormat(QPrinter::PdfFormat);
  ASSERT_FALSE(printer.fullPage());
  const ReportPaper paper{.size = QPageSize::A5};
  EXPECT_TRUE(printer.setPageLayout(paper.layout()));
  EXPECT_TRUE(printer.fullPage());
  EXPECT_EQ(printer.pageLayout().pageSize().id(), QPageSize::A5);
}

TEST_F(ReportSheetTest, BreaksALongTextAsAShortOne) {
  const QString wide = QString::fromUtf8("测量导轨，读数如下。").repeated(700);
  for (const QString& text : {words(300, u'n'), words(1999, u'n'), words(2001, u'i'), words(9000, u'm'),
                              QString(7001, u'x'), words(2500, u'é') + QString(5000, u'-'), wide}) {
    const QStringList lines = sheet().lines(text, type::body, ReportSheet::width);
    EXPECT_EQ(lines, atOnce(text)) << text.left(30).toStdString() << "… of " << text.size();
  }
}

// Qt lays out nothing of a text of half a million letters.
TEST_F(ReportSheetTest, PrintsAllOfALongText) {
  const QString letters = QString(600'000, u'x');
  EXPECT_EQ(sheet().lines(letters, type::body, ReportSheet::width).join(QString()), letters);
}

}  // namespace
}  // namespace alidade::ui
