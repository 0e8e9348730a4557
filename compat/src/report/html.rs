//! The page: self-contained, with POV-Ray's picture, povista's and the heat map side by side.

use std::fmt::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::report::Report;
use crate::suite::Case;
use crate::verdict::Verdict;

/// Style, script and the places for what a run found.
const PAGE: &str = include_str!("page.html");

/// The whole page; `reason` tells why a scene is known not to match.
pub fn page(report: &Report, reason: impl Fn(&str) -> Option<String>) -> String {
    let cards: String = report.cases.iter().map(|case| card(case, reason(&case.scene))).collect();
    let chips: String = Verdict::ALL
        .into_iter()
        .filter(|&verdict| report.count(verdict) > 0)
        .map(|verdict| {
            let count = report.count(verdict);
            format!("<button class=\"chip {verdict}\" data-verdict=\"{verdict}\"><b>{count}</b> {verdict}</button>\n")
        })
        .collect();
    let compared = report.cases.len() - report.count(Verdict::Excluded);
    let share = 100.0 * report.count(Verdict::Match) as f64 / compared.max(1) as f64;
    // The cards come last, so that nothing in a message is taken for one of these places.
    PAGE.replace("{{povray}}", &escape(report.povray))
        .replace("{{povista}}", &escape(report.povista))
        .replace("{{matching}}", &format!("{} of {compared}", report.count(Verdict::Match)))
        .replace("{{share}}", &format!("{share:.1}"))
        .replace("{{chips}}", &chips)
        .replace("{{cards}}", &cards)
}

fn card(case: &Case, reason: Option<String>) -> String {
    let scene = escape(&case.scene);
    let rank = Verdict::ALL.iter().position(|&v| v == case.verdict).unwrap_or(0);
    let rmse = case.difference.map_or(-1.0, |d| d.rmse);
    let near = case.difference.map_or(-1.0, |d| d.near);
    let ratio = case.times.map_or(0.0, |times| times.ratios().wall);
    let mut card = format!(
        "<article class=\"{verdict}\" data-scene=\"{scene}\" data-verdict=\"{verdict}\" data-rank=\"{rank}\" \
         data-rmse=\"{rmse}\" data-near=\"{near}\" data-ratio=\"{ratio}\">\n\
         <h2><span class=\"badge\">{verdict}</span> {scene}</h2>\n",
        verdict = case.verdict
    );
    card.push_str("<div class=\"pictures\">\n");
    for (picture, title) in case.pictures.iter().zip(["POV-Ray", "povista", "difference"]) {
        // Writing to a string cannot fail, here and below.
        let _ = match picture {
            Some(png) => writeln!(
                card,
                "<figure><img alt=\"{title}\" src=\"data:image/png;base64,{}\"><figcaption>{title}</figcaption></figure>",
                STANDARD.encode(png)
            ),
            None => {
                writeln!(card, "<figure class=\"none\"><div></div><figcaption>{title}</figcaption></figure>")
            }
        };
    }
    card.push_str("</div>\n<p class=\"figures\">");
    if let Some(d) = &case.difference {
        let _ = write!(
            card,
            "worst <b>{}</b> · within 2/255 <b>{:.2} %</b> · mean <b>{:.3}</b> · RMSE <b>{:.2}</b>",
            d.worst,
            d.near_percent(),
            d.mean,
            d.rmse
        );
    }
    if let Some(spread) = &case.spread {
        let _ = write!(card, " · own spread <b>{:.2}</b>", spread.rmse);
    }
    if let Some(times) = &case.times {
        let _ = write!(
            card,
            "<br>POV-Ray <b>{:.3} s</b> · povista <b>{:.3} s</b> · <b>{:.1}</b> times as fast",
            times.povray.wall,
            times.povista.wall,
            times.ratios().wall
        );
    }
    card.push_str("</p>\n");
    if !case.message.is_empty() {
        let _ = writeln!(card, "<p class=\"message\">{}</p>", escape(&case.message));
    }
    if let Some(reason) = reason {
        let _ = writeln!(card, "<p class=\"reason\">Known: {}</p>", escape(&reason));
    }
    card.push_str("</article>\n");
    card
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expectations::tests::case;

    #[test]
    fn the_page_holds_everything_and_fetches_nothing() {
        let mut good = case("good.pov", Verdict::Match, "");
        good.pictures = [Some(b"theirs".to_vec()), Some(b"ours".to_vec()), Some(b"heat".to_vec())];
        let bad = case("bad.pov", Verdict::Refused, "error: `<1,2` & \"{{chips}}\"");
        let report = Report { povray: "POV-Ray 3.7", povista: "povista 0", cases: &[good, bad] };
        let page = page(&report, |scene| (scene == "bad.pov").then(|| "vectors > 3".to_owned()));
        for part in [
            "1 of 2",
            "data:image/png;base64,dGhlaXJz",
            "data:image/png;base64,b3Vycw==",
            "error: `&lt;1,2` &amp; &quot;{{chips}}&quot;",
            "Known: vectors &gt; 3",
            "data-verdict=\"refused\"><b>1</b>",
        ] {
            assert!(page.contains(part), "{part}");
        }
        assert!(!page.contains("http:") && !page.contains("https:") && !page.contains("src=\"/"));
        assert_eq!(page.matches("{{").count(), 1);
    }
}
