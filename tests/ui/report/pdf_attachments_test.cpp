#include "ui/report/pdf_attachments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <QByteArray>
#include <algorithm>
#include <array>

#include "tests/support/guarded_memory.h"

// A few bytes of a PDF may expand to very many: reading is limited for any content.

namespace alidade::ui {
namespace {

using Outcome = AttachedFile::Outcome;

/// Compressed by zlib (/FlateDecode).
std::string deflated(const std::string& bytes) {
  constexpr int lengthAhead = 4;  // Qt writes the length before it
  return qCompress(QByteArray::fromStdString(bytes), 9).mid(lengthAhead).toStdString();
}

std::string deflated(std::string bytes, int times) {
  for (int i = 0; i < times; ++i) bytes = deflated(bytes);
  return bytes;
}

std::string filters(int times) {
  std::string names = "[";
  for (int i = 0; i < times; ++i) names += " /FlateDecode";
  return names + " ]";
}

/// A PDF built piece by piece, with a table of object offsets.
class HandWritten {
 public:
  void add(const std::string& object) {
    m_begins.push_back(m_bytes.size());
    m_bytes += std::to_string(m_begins.size()) + " 0 obj\n" + object + "\nendobj\n";
  }
  void addStream(const std::string& entries, const std::string& content) {
    add("<< " + entries + " /Length " + std::to_string(content.size()) + " >>\nstream\n" + content +
        "\nendstream");
  }
  /// Returns the PDF with a cross-reference table as in PDF 1.4.
  std::string withTable() const {
    std::string table = "xref\n0 " + std::to_string(m_begins.size() + 1) + "\n0000000000 65535 f \n";
    for (const std::size_t begin : m_begins) {
      const std::string digits = std::to_string(begin);
      table += std::string(10 - digits.size(), '0') + digits + " 00000 n \n";
    }
    return m_bytes + table + "trailer << /Size " + std::to_string(m_begins.size() + 1) +
           " /Root 1 0 R >>\nstartxref\n" + std::to_string(m_bytes.size()) + "\n%%EOF\n";
  }
  /// Returns the PDF with a cross-reference stream. Object 1, which was added as a placeholder, is the first
  /// one in object stream 2.
  std::string withStreamOfTable() {
    const std::size_t at = m_bytes.size();
    std::string table;
    const auto entry = [&](int kind, std::size_t first, int second) {
      table += static_cast<char>(kind);
      for (const int shift : {24, 16, 8, 0}) table += static_cast<char>(first >> shift & 0xFFU);
      table += static_cast<char>(second);
    };
    entry(0, 0, 0);
    entry(2, 2, 0);
    entry(1, m_begins[1], 0);
    entry(1, at, 0);
    return m_bytes + "3 0 obj\n<< /Type /XRef /Size 4 /W [1 4 1] /Root 1 0 R /Length " +
           std::to_string(table.size()) + " >>\nstream\n" + table + "\nendstream\nendobj\nstartxref\n" +
           std::to_string(at) + "\n%%EOF\n";
  }

 private:
  std::string m_bytes = "%PDF-1.7\n";
  std::vector<std::size_t> m_begins;
};

constexpr std::size_t mebibyte = std::size_t{1} << 20;

/// A document whose catalogue is in an object stream deflated `times` times that expands to `bytes`.
std::string inObjectStream(std::size_t bytes, int times, const std::string& filler = " ") {
  std::string objects = "1 0 << /Type /Catalog >>";
  while (objects.size() < bytes)
    objects += filler.size() == 1 ? std::string(bytes - objects.size(), filler[0]) : filler;
  HandWritten pdf;
  pdf.add("null");
  pdf.addStream("/Type /ObjStm /N 1 /First 4 /Filter " + filters(times), deflated(objects, times));
  return pdf.withStreamOfTable();
}

/// A document with an attached file, deflated `times` times.
std::string withFile(const std::string& content, int times) {
  HandWritten pdf;
  pdf.add("<< /Type /Catalog /Names << /EmbeddedFiles << /Names [(a) 2 0 R] >> >> >>");
  pdf.add("<< /Type /Filespec /F (a.alidade) /UF (a.alidade) /EF << /F 3 0 R >> >>");
  pdf.addStream("/Type /EmbeddedFile /Filter " + filters(times), deflated(content, times));
  return pdf.withTable();
}

TEST(PdfAttachments, ADocumentThatUnfoldsWithinTheLimitsIsRead) {
  EXPECT_EQ(attachedFile(inObjectStream(mebibyte, 2), ".alidade", {.mostBytes = mebibyte}).outcome,
            Outcome::NotThere);
  const AttachedFile file = attachedFile(withFile("{}", 2), ".ALIDADE", {.mostBytes = 2});
  EXPECT_EQ(file.outcome, Outcome::Found);
  EXPECT_EQ(file.bytes, "{}");
}

TEST(PdfAttachments, AnObjectStreamThatUnfoldsWithoutEndIsRefused) {
#ifdef ALIDADE_MEMORY_IS_GUARDED
  GTEST_SKIP() << "a sanitizer ends the process by itself";
#endif
  constexpr std::size_t most = 24 * mebibyte;
  for (const int times : {1, 2, 3}) {
    const std::string pdf = inObjectStream(2 * most, times);
    EXPECT_LT(pdf.size(), most / 400) << times;
    EXPECT_EQ(attachedFile(pdf, ".alidade", {.mostBytes = mebibyte, .mostMemory = most}).outcome,
              Outcome::Exhausting)
        << times;
  }
  rusage used{};
  ASSERT_EQ(getrusage(RUSAGE_CHILDREN, &used), 0);
  rusage own{};
  ASSERT_EQ(getrusage(RUSAGE_SELF, &own), 0);
  EXPECT_LT(used.ru_maxrss, own.ru_maxrss + static_cast<long>(most / 1024));
}

// Objects take a hundred times the memory of their text, deflated or not.
TEST(PdfAttachments, SoIsADocumentOfVeryManyObjects) {
#ifdef ALIDADE_MEMORY_IS_GUARDED
  GTEST_SKIP() << "a sanitizer ends the process by itself";
#endif
  std::string many;
  for (int i = 0; i < 2'000'000; ++i) many += "1 ";
  HandWritten pdf;
  pdf.add("<< /Type /Catalog /Many [" + many + "] >>");
  EXPECT_EQ(
      attachedFile(pdf.withTable(), ".alidade", {.mostBytes = mebibyte, .mostMemory = 48 * mebibyte}).outcome,
      Outcome::Exhausting);
}

TEST(PdfAttachments, AFileThatUnfoldsBeyondTheLimitIsTooLarge) {
  for (const int times : {1, 2}) {
    const std::string pdf = withFile(std::string(32 * mebibyte, 'x'), times);
    EXPECT_EQ(attachedFile(pdf, ".alidade", {.mostBytes = mebibyte}).outcome, Outcome::TooLarge) << times;
    EXPECT_EQ(attachedFile(pdf, ".alidade", {.mostBytes = 32 * mebibyte}).bytes.size(), 32 * mebibyte)
        << times;
  }
}

TEST(PdfAttachments, WhatIsNoPdfSaysSo) {
  const AttachedFile none = attachedFile("%PDF-1.7\nnothing more", ".alidade", {.mostBytes = mebibyte});
  EXPECT_EQ(none.outcome, Outcome::Unreadable);
  EXPECT_THAT(none.failure, testing::HasSubstr("report"));
}

}  // namespace
}  // namespace alidade::ui
