// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the catalogues with the strings of the sources, which are extracted again into copies of them.
#include <set>
#include <string>
#include <vector>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include "tests/translations/catalogue.h"

namespace proveout {
namespace {

const QString kRoot = QStringLiteral(PROVEOUT_SOURCE_DIR);

/// Copies of the catalogues, updated from the sources like the target update_catalogues does.
class UpdatedCopies {
public:
    UpdatedCopies() {
        const QDir committed(kRoot + "/translations");
        for (const QString& name : committed.entryList({"proveout_*.ts"}))
            QFile::copy(committed.filePath(name), m_folder.filePath(name));
        QProcess update;
        update.setProcessChannelMode(QProcess::MergedChannels);
        update.start(PROVEOUT_CMAKE, {"-DLUPDATE=" PROVEOUT_LUPDATE, "-DSOURCE_DIR=" + kRoot,
                                      "-DCATALOGUES=" + m_folder.path(), "-P",
                                      kRoot + "/translations/update_catalogues.cmake"});
        update.waitForFinished(120'000);
        m_worked = update.exitStatus() == QProcess::NormalExit && update.exitCode() == 0;
        m_output = update.readAll().toStdString();
    }

    [[nodiscard]] bool worked() const { return m_worked; }
    [[nodiscard]] const std::string& output() const { return m_output; }
    [[nodiscard]] std::vector<CatalogueMessage> messages(const std::string& language) const {
        return readCatalogue(m_folder.filePath(QString::fromStdString("proveout_" + language + ".ts")));
    }

private:
    QTemporaryDir m_folder;
    bool m_worked = false;
    std::string m_output;
};

const UpdatedCopies& updatedCopies() {
    static const UpdatedCopies kCopies;
    return kCopies;
}

std::vector<CatalogueMessage> committedMessages(const std::string& language) {
    return readCatalogue(kRoot + QString::fromStdString("/translations/proveout_" + language + ".ts"));
}

class Catalogue : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override { ASSERT_TRUE(updatedCopies().worked()) << updatedCopies().output(); }
    [[nodiscard]] bool isPluralOnly() const { return GetParam() == "en"; }
};

TEST_P(Catalogue, HoldsEveryStringOfTheSourcesTranslated) {
    std::size_t core = 0;
    for (const CatalogueMessage& message : updatedCopies().messages(GetParam())) {
        core += message.context == QLatin1String("Core") ? 1 : 0;
        EXPECT_EQ(message.state.toStdString(), "") << message.name().toStdString();
        for (const QString& translation : message.translations)
            EXPECT_FALSE(translation.isEmpty()) << "untranslated: " << message.name().toStdString();
    }
    EXPECT_TRUE(core > 20 || isPluralOnly()) << "the strings of the core were not found";
}

TEST_P(Catalogue, HoldsNothingThatIsGone) {
    std::set<QString> alive;
    for (const CatalogueMessage& message : updatedCopies().messages(GetParam()))
        alive.insert(message.name());
    for (const CatalogueMessage& message : committedMessages(GetParam()))
        EXPECT_EQ(alive.count(message.name()), 1U) << "gone: " << message.name().toStdString();
}

TEST_P(Catalogue, CarriesPlaceholdersOver) {
    for (const CatalogueMessage& message : committedMessages(GetParam())) {
        for (const QString& translation : message.translations) {
            QStringList expected = placeholders(message.source);
            QStringList found = placeholders(translation);
            if (message.numerus) { // "one block" may omit the number
                expected.removeAll(QStringLiteral("%n"));
                found.removeAll(QStringLiteral("%n"));
            }
            EXPECT_EQ(found.join(' ').toStdString(), expected.join(' ').toStdString())
                << message.name().toStdString();
        }
    }
}

TEST_P(Catalogue, CarriesKeysAndEllipsesOver) {
    const auto hasKey = [](QString text) { return text.remove(QStringLiteral("&&")).contains('&'); };
    for (const CatalogueMessage& message : committedMessages(GetParam())) {
        for (const QString& translation : message.translations) {
            EXPECT_EQ(hasKey(translation), hasKey(message.source)) << message.name().toStdString();
            EXPECT_EQ(translation.endsWith(QChar(0x2026)), message.source.endsWith(QChar(0x2026)))
                << message.name().toStdString();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, Catalogue, testing::Values("de", "en", "ko"),
                         [](const testing::TestParamInfo<std::string>& each) { return each.param; });

TEST(Placeholders, AreFound) {
    EXPECT_EQ(placeholders(QStringLiteral("{} of %1 at %L2, {2}, %n")).join(' ').toStdString(),
              "%1 %L2 %n {} {}");
    EXPECT_TRUE(placeholders(QStringLiteral("100 % done")).isEmpty());
}

} // namespace
} // namespace proveout
