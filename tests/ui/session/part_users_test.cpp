// SPDX-License-Identifier: GPL-3.0-or-later
// Who has stocks compared with the part of the job.
#include <memory>

#include <QObject>
#include <QTest>

#include "tests/ui/opened.h"
#include "tests/ui/part_job.h"

namespace proveout {
namespace {

constexpr int kPatience = 30'000; ///< ms

} // namespace

class PartUsersTest : public QObject {
    Q_OBJECT

private slots:
    void comparesWhileAnybodyLooks() {
        const PartJob job;
        Session session;
        PartHub& hub = session.part();
        const QObject first;
        auto second = std::make_unique<QObject>();
        QVERIFY(opened(session, job.withPart));
        QTRY_VERIFY_WITH_TIMEOUT(hub.contents().part != nullptr, kPatience);
        QVERIFY(hub.comparison() == nullptr && !hub.progress());

        hub.setOn(first, true);
        hub.setOn(*second, true);
        hub.setOn(*second, true);
        QTRY_VERIFY_WITH_TIMEOUT(hub.comparison() != nullptr, kPatience);
        hub.setOn(first, false);
        QVERIFY(hub.comparison() != nullptr);
        second.reset();
        QVERIFY(hub.comparison() == nullptr && !hub.progress());
    }
};

} // namespace proveout

QTEST_GUILESS_MAIN(proveout::PartUsersTest)

#include "part_users_test.moc"
