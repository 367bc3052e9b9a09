#pragma once

#include "LesionForm.h"
#include "SceneRepresentation.h"
#include "StudyController.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QVBoxLayout>

#include <functional>
#include <vector>

namespace palpate
{
/// All touch settings of one structure, including those without a table column. Accepting it is one
/// undo step of the study.
class StructureDialog : public QDialog
{
  Q_OBJECT

public:
  /// Keeps the address. `id` is the structure's.
  StructureDialog(StudyController& study, int id, QWidget* parent = nullptr);

  void accept() override;

private:
  void AddRepresentation();
  QWidget* MakeRows(const SceneRepresentation& representation);
  void AddModelMembers();
  void AddContactMembers();
  void AddNumber(const QString& label, const QString& name, double most, int decimals,
                 const std::function<double&(SceneStructure&)>& member);
  QComboBox* AddChoice(const QString& label, const QString& name, const QStringList& choices,
                       int value, const std::function<void(SceneStructure&, int)>& set);
  QDoubleSpinBox* AddBox(const SceneNumber& number, double value,
                         const std::function<void(SceneStructure&, double)>& set);
  void AddNumbers(const std::vector<SceneNumber>& numbers);
  void AddOne(const SceneNumber& number);
  void AddEffect(const SceneEffectKind& kind, QVBoxLayout* groups);
  QStringList OpenVolumes() const;
  void AddImage(const std::string& label, const std::string& key);

  StudyController& Study;
  SceneStructure Structure;
  QFormLayout* Form = nullptr; ///< of the tab that is filled
  QFormLayout* Rows = nullptr; ///< to which rows are added
  std::vector<std::function<void(SceneStructure&)>> Writes;
  LesionForm* Lesion = nullptr; ///< of a structure that can yield
};
} // namespace palpate
