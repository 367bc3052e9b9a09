#include "SnapshotSlot.h"

#include <gtest/gtest.h>

#include <thread>

namespace palpate::snapshot_slot_test
{
namespace
{
// Records which thread destroys it and how many exist.
struct Snapshot
{
  struct Ledger
  {
    std::thread::id Publisher = std::this_thread::get_id();
    std::atomic<int> Alive{0};
    std::atomic<int> DestroyedElsewhere{0};
  };

  Snapshot(Ledger& ledger, int value) : Book(ledger), Value(value) { ++ledger.Alive; }
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;
  ~Snapshot()
  {
    --this->Book.Alive;
    this->Book.DestroyedElsewhere += std::this_thread::get_id() != this->Book.Publisher ? 1 : 0;
    this->Value = -1;
  }

  Ledger& Book;
  int Value;
};

TEST(SnapshotSlot, ServoKeepsCurrentUntilNewer)
{
  Snapshot::Ledger ledger;
  SnapshotSlot<Snapshot> slot;
  EXPECT_FALSE(slot.Refresh());
  EXPECT_EQ(slot.Current(), nullptr);
  slot.Publish(std::make_unique<Snapshot>(ledger, 1));
  EXPECT_TRUE(slot.Refresh());
  EXPECT_EQ(slot.Current()->Value, 1);
  EXPECT_FALSE(slot.Refresh());
  slot.Publish(nullptr);
  EXPECT_FALSE(slot.Refresh());
  EXPECT_EQ(slot.Current()->Value, 1);
}

TEST(SnapshotSlot, PublishDestroysUntakenObject)
{
  Snapshot::Ledger ledger;
  SnapshotSlot<Snapshot> slot;
  slot.Publish(std::make_unique<Snapshot>(ledger, 1));
  slot.Publish(std::make_unique<Snapshot>(ledger, 2));
  EXPECT_EQ(ledger.Alive, 1);
  EXPECT_TRUE(slot.Refresh());
  EXPECT_EQ(slot.Current()->Value, 2);
}

TEST(SnapshotSlot, OnlyReclaimDestroys)
{
  Snapshot::Ledger ledger;
  SnapshotSlot<Snapshot> slot;
  slot.Publish(std::make_unique<Snapshot>(ledger, 1));
  slot.Refresh();
  slot.Publish(std::make_unique<Snapshot>(ledger, 2));
  slot.Refresh();
  EXPECT_EQ(ledger.Alive, 2);
  slot.Reclaim();
  EXPECT_EQ(ledger.Alive, 1);
}

TEST(SnapshotSlot, PublishDestroysReturnedObjects)
{
  Snapshot::Ledger ledger;
  {
    SnapshotSlot<Snapshot> slot;
    for (int i = 0; i < 20; ++i)
    {
      slot.Publish(std::make_unique<Snapshot>(ledger, i));
      slot.Refresh();
      // The one in use, and the previous one.
      EXPECT_LE(ledger.Alive, 2);
    }
  }
  EXPECT_EQ(ledger.Alive, 0);
}

TEST(SnapshotSlot, DestructorDestroysAll)
{
  Snapshot::Ledger ledger;
  {
    SnapshotSlot<Snapshot> slot;
    for (int i = 0; i < 2; ++i)
    {
      slot.Publish(std::make_unique<Snapshot>(ledger, i));
      slot.Refresh();
    }
    slot.Publish(std::make_unique<Snapshot>(ledger, 3));
  }
  EXPECT_EQ(ledger.Alive, 0);
}

TEST(SnapshotSlot, PublisherDestroysAllDuringServo)
{
  constexpr int last = 20'000;
  Snapshot::Ledger ledger;
  {
    SnapshotSlot<Snapshot> slot;
    std::atomic<bool> isOrdered{true};
    std::thread servo(
        [&]
        {
          // A destroyed snapshot, or an older one, would show as a smaller value.
          for (int seen = 0; seen < last;)
          {
            slot.Refresh();
            const int value = slot.Current() != nullptr ? slot.Current()->Value : 0;
            isOrdered = isOrdered && value >= seen;
            seen = isOrdered ? value : last;
          }
        });
    for (int i = 1; i <= last; ++i)
    {
      slot.Publish(std::make_unique<Snapshot>(ledger, i));
    }
    servo.join();
    EXPECT_TRUE(isOrdered);
  }
  EXPECT_EQ(ledger.Alive, 0);
  EXPECT_EQ(ledger.DestroyedElsewhere, 0);
}
} // namespace
} // namespace palpate::snapshot_slot_test
