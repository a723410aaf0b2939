// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/translations/catalogue.h"

#include <utility>

#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>

namespace proveout {

namespace {

CatalogueMessage readMessage(QXmlStreamReader& xml, const QString& context) {
    CatalogueMessage message;
    message.context = context;
    message.numerus = xml.attributes().value(QStringLiteral("numerus")) == QLatin1String("yes");
    while (xml.readNextStartElement()) {
        if (xml.name() == QLatin1String("source")) {
            message.source = xml.readElementText();
        } else if (xml.name() == QLatin1String("comment")) {
            message.comment = xml.readElementText();
        } else if (xml.name() == QLatin1String("translation")) {
            message.state = xml.attributes().value(QStringLiteral("type")).toString();
            if (message.numerus) {
                while (xml.readNextStartElement())
                    message.translations += xml.readElementText();
            } else {
                message.translations += xml.readElementText();
            }
        } else {
            xml.skipCurrentElement();
        }
    }
    return message;
}

} // namespace

QString CatalogueMessage::name() const {
    return context + QLatin1String(" | ") + source + QLatin1String(" | ") + comment;
}

std::vector<CatalogueMessage> readCatalogue(const QString& path) {
    QFile file(path);
    std::vector<CatalogueMessage> messages;
    if (!file.open(QIODevice::ReadOnly))
        return messages;
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("name"))
            context = xml.readElementText();
        else if (xml.name() == QLatin1String("message"))
            messages.push_back(readMessage(xml, context));
    }
    return xml.hasError() ? std::vector<CatalogueMessage>{} : messages;
}

QStringList placeholders(const QString& text) {
    static const QRegularExpression kPlaceholder(QStringLiteral("%L?[0-9]+|%n|\\{[0-9]*\\}"));
    QStringList found;
    for (auto match = kPlaceholder.globalMatch(text); match.hasNext();) {
        const QString placeholder = match.next().captured();
        found += placeholder.startsWith(QLatin1Char('{')) ? QStringLiteral("{}") : placeholder;
    }
    found.sort();
    return found;
}

} // namespace proveout
