#pragma once

#include "StudyController.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QWidget>

#include <functional>
#include <vector>

namespace palpate
{
/// Options of the fit: the most important ones, and the others folded away. Each change is an undo
/// step of the study.
class FitPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  FitPanel(StudyController& study, QWidget* parent);

private:
  void AddImportant(QFormLayout* form);
  void AddOthers(QFormLayout* form);
  struct Range
  {
    double Low, High, Step;
    int Decimals;
  };
  void AddNumber(QFormLayout* form, const QString& label, const QString& message,
                 const Range& range, std::function<double(const StudyState&)> get,
                 std::function<void(StudyState&, double)> set);
  void AddChoice(QFormLayout* form, const QString& label, const QString& message,
                 const QStringList& choices, std::function<int(const StudyState&)> get,
                 std::function<void(StudyState&, int)> set);
  void Show();
  /// Of all available models.
  void ShowCoverage();

  StudyController& Study;
  QLabel* Coverage = nullptr;
  QLabel* CoverageTitle = nullptr;
  std::vector<std::function<void(const StudyState&)>> Shows; ///< one per option
};
} // namespace palpate
