#pragma once

#include <QTranslator>
#include <memory>
#include <vector>

namespace alidade::ui {

/// A language with its texts: the program's, then Qt's own. English has none.
struct Tongue {
  QString id;
  std::vector<std::unique_ptr<QTranslator>> texts;
};

/// The tongue of an id; null: the program does not speak it.
const Tongue* tongueOf(const QString& id);

/// Translates into what the asking thread speaks.
class Interpreter : public QTranslator {
  Q_OBJECT

 public:
  using QTranslator::QTranslator;

  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char* disambiguation,
                    int n) const override;

  /// Of the program; of this thread, null where it has none of its own.
  static void setTongue(const Tongue* tongue);
  static const Tongue*& ownTongue();
  static const Tongue* tongue();
};

}  // namespace alidade::ui
