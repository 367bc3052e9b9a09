#pragma once

#include "GuideSettings.h"
#include "StudyController.h"

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>

#include <vector>

namespace palpate
{
/// How a structure guides the tool: not, or keeps it inside, outside or on the surface. Accepting
/// it is one undo step of the study.
class GuideDialog : public QDialog
{
  Q_OBJECT

public:
  /// Keeps the address. `id` is that of the structure shown first.
  GuideDialog(StudyController& study, int id, QWidget* parent = nullptr);

  void accept() override;

private:
  QDoubleSpinBox* AddNumber(const QString& label, const char* name, double least, double most,
                            int decimals);
  void AddChoices(int id);
  void ShowStructure();
  void EnableNumbers();
  GuideSettings Chosen() const;
  int ChosenId() const { return this->Structures->currentData().toInt(); }

  StudyController& Study;
  QFormLayout* Form;
  QComboBox* Structures;
  QComboBox* Kind;
  QDoubleSpinBox* Distance;
  QDoubleSpinBox* Stiffness;
  QDoubleSpinBox* Range;
  QDoubleSpinBox* LargestForce;
};
} // namespace palpate
