#pragma once

#include "StudyState.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>

namespace palpate
{
/// The lesion in a structure that yields: which of the other labels it is, and its modulus.
class LesionForm : public QGroupBox
{
  Q_OBJECT

public:
  /// `id` is the structure that yields.
  LesionForm(const StudyState& state, int id, QWidget* parent);

  /// Adds a choice of published moduli above the rows of the tissue, for both.
  void AddPresets(QFormLayout* tissue, QDoubleSpinBox* modulus);
  /// Writes what was changed.
  void Write(StudyState& state) const;

private:
  QComboBox* Which;
  QDoubleSpinBox* Modulus; ///< kPa
  int Before = 0;          ///< id of the lesion that was shown first
  double ModulusBefore = 0.0;
};
} // namespace palpate
