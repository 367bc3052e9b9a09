#include "KeysPage.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace palpate
{
KeysPage::KeysPage(KeyBindings& keys, QWidget* parent)
    : QWidget(parent), Keys(keys),
      Table(new QTableWidget(static_cast<int>(keys.Entries().size()), 2, this)),
      Edit(new QKeySequenceEdit(this)), Message(new QLabel(this))
{
  this->Table->setObjectName("keys");
  this->Table->setAccessibleName("Actions and their keys");
  this->Table->setHorizontalHeaderLabels({"Action", "Key"});
  this->Table->verticalHeader()->hide();
  this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
  this->Table->setSelectionMode(QAbstractItemView::SingleSelection);
  this->Table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Table->setTabKeyNavigation(false);
  this->Table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  this->Table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  this->Table->setMinimumHeight(20 * this->fontMetrics().lineSpacing());
  this->Edit->setObjectName("key");
  auto* label = new QLabel("&New key", this);
  label->setBuddy(this->Edit);
  auto* none = new QPushButton("N&o key", this);
  none->setObjectName("no-key");
  this->Message->setObjectName("key-message");
  this->Message->setWordWrap(true);
  this->Message->setMinimumHeight(2 * this->fontMetrics().lineSpacing()); // nothing moves
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(this->Edit, 1);
  row->addWidget(none);
  auto* column = new QVBoxLayout(this);
  column->addWidget(this->Table, 1);
  column->addLayout(row);
  column->addWidget(this->Message);
  connect(this->Table, &QTableWidget::itemSelectionChanged, this, &KeysPage::ShowSelected);
  this->Edit->installEventFilter(this);
  connect(none, &QPushButton::clicked, this, [this] { this->Take({}); });
  this->ShowKeys();
  this->Table->selectRow(0);
}

void KeysPage::ShowKeys()
{
  int row = 0;
  for (const KeyBindings::Entry& entry : this->Keys.Entries())
  {
    const QKeySequence key = entry.Action->shortcut();
    this->Table->setItem(row, 0, new QTableWidgetItem(entry.Name));
    auto* cell = new QTableWidgetItem(key.toString(QKeySequence::NativeText));
    QFont font = cell->font();
    font.setBold(key != entry.Default);
    cell->setFont(font);
    this->Table->setItem(row, 1, cell);
    ++row;
  }
}

QKeySequence KeysPage::SelectedKey() const
{
  const int row = this->Table->currentRow();
  return row < 0 ? QKeySequence()
                 : this->Keys.Entries().at(static_cast<std::size_t>(row)).Action->shortcut();
}

void KeysPage::ShowSelected()
{
  this->Message->clear();
  const QSignalBlocker quiet(this->Edit);
  this->Edit->setKeySequence(this->SelectedKey());
}

// The field itself would wait for a second whether further strokes follow the first. Keys that are
// released after the first one find the field as it was shown.
bool KeysPage::eventFilter(QObject* watched, QEvent* event)
{
  const QKeySequence typed = this->Edit->keySequence();
  if (event->type() == QEvent::KeyRelease && !static_cast<QKeyEvent*>(event)->isAutoRepeat() &&
      !typed.isEmpty() && typed != this->SelectedKey())
  {
    this->Take(typed);
  }
  return QWidget::eventFilter(watched, event);
}

// The first stroke counts. If it is refused, the key stays as it was.
void KeysPage::Take(const QKeySequence& key)
{
  const int row = this->Table->currentRow();
  if (row < 0)
  {
    return;
  }
  const QKeySequence first = key.isEmpty() ? QKeySequence() : QKeySequence(key[0]);
  const QString refused = this->Keys.Change(static_cast<std::size_t>(row), first);
  this->ShowKeys();
  this->ShowSelected();
  this->Message->setText(refused);
}

void KeysPage::RestoreDefaults()
{
  this->Keys.RestoreDefaults();
  this->ShowKeys();
  this->ShowSelected();
}
} // namespace palpate
