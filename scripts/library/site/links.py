"""Checks the finished website: every link leads somewhere in it, and nothing is fetched from elsewhere."""
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Links(HTMLParser):
    """What a page links to, what it fetches, and the names in it that links can have."""

    def __init__(self, text):
        super().__init__()
        self.places, self.links, self.fetched = {"", "__top"}, [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.places |= {values[key] for key in ("id", "name") if values.get(key)}
        if tag == "a" and "href" in values:
            self.links.append(values["href"])
        elif tag == "link" and "href" in values:
            self.fetched.append(values["href"])
        elif values.get("src"):
            self.fetched.append(values["src"])


def broken_links(site):
    """One sentence for each link of the website's pages that leads nowhere, and for each thing that it fetches from elsewhere.

    site: the folder of a website whose links are relative
    """
    pages = {path: Links(path.read_text()) for path in sorted(Path(site).rglob("*.html"))}
    wrong = []
    for path, page in pages.items():
        name = path.relative_to(site)
        wrong += [f"{name} fetches {link}" for link in page.fetched
                  if urlsplit(link).scheme not in ("", "data", "blob") or urlsplit(link).netloc]
        for link in page.links + page.fetched:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if target.is_dir():
                target /= "index.html"
            if not target.exists():
                wrong.append(f"{name} links to {link}, which does not exist")
            elif target in pages and unquote(parts.fragment) not in pages[target].places:
                wrong.append(f"{name} links to {link}, but there is no such section")
    return wrong
