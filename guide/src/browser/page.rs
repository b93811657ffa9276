//! A visit to one page.

use std::{
    fs,
    path::Path,
    sync::{Arc, Mutex},
    thread,
    time::{Duration, Instant},
};

use headless_chrome::{
    Browser, Tab,
    protocol::cdp::{
        Emulation, Log, Network, Page::CaptureScreenshotFormatOption as Format, Runtime,
        types::Event,
    },
};
use mdbook_preprocessor::errors::{Error, Result};
use serde_json::Value;
use url::Url;

/// The script that inspects the page.
const INSPECT: &str = include_str!("inspect.js");

/// The longest wait for a page.
const PATIENCE: Duration = Duration::from_secs(30);

/// How long after the inspection a late request or error of a script is still seen.
const LATE: Duration = Duration::from_millis(100);

/// What was seen on a page.
pub(super) struct Visit {
    pub(super) url: Url,
    pub(super) ids: Vec<String>,
    pub(super) links: Vec<Link>,
    pub(super) findings: Vec<String>,
}

/// A link.
pub(super) struct Link {
    /// As written.
    pub(super) text: String,
    /// Where it leads, without the anchor.
    pub(super) to: Url,
    pub(super) anchor: String,
}

impl Visit {
    /// Returns the path of the page below `folder`.
    pub(super) fn name(&self, folder: &Path) -> String {
        let path = self.url.to_file_path().unwrap_or_default();
        path.strip_prefix(folder).unwrap_or(&path).display().to_string()
    }
}

/// Opens a page in a window of this width, and inspects it.
pub(super) fn visit(
    browser: &Browser,
    folder: &Path,
    page: &Path,
    width: u32,
    picture: Option<&Path>,
) -> Result<Visit> {
    let unnamed = || Error::msg(format!("{} has no address", page.display()));
    let url = Url::from_file_path(page).map_err(|()| unnamed())?;
    let base = Url::from_directory_path(folder).map_err(|()| unnamed())?;
    let tab = browser.new_tab()?;
    resize(&tab, width, 800)?;
    let events = listen(&tab, base)?;
    tab.navigate_to(url.as_str())?;
    wait_for(&tab, &url)?;
    let seen = text(&tab, INSPECT)?;
    let seen: Value = serde_json::from_str(&seen)?;
    thread::sleep(LATE);
    if let Some(picture) = picture {
        let height = seen["height"].as_u64().unwrap_or(0).clamp(400, 12_000);
        resize(&tab, width, u32::try_from(height)?)?;
        fs::write(picture, tab.capture_screenshot(Format::Png, None, None, true)?)?;
    }
    tab.close(false)?;

    let strings = |key: &str| {
        let list = seen[key].as_array().into_iter().flatten();
        list.filter_map(Value::as_str).map(str::to_owned).collect::<Vec<_>>()
    };
    let mut links = Vec::new();
    for link in seen["links"].as_array().into_iter().flatten() {
        let part = |key: &str| link[key].as_str().unwrap_or_default().to_owned();
        links.push(Link {
            text: part("text"),
            to: Url::parse(&part("to"))?,
            anchor: part("anchor"),
        });
    }
    let mut findings = strings("findings");
    let events = events.lock().map_err(|_| Error::msg("a listener panicked"))?;
    findings.extend(events.iter().cloned());
    Ok(Visit { url, ids: strings("ids"), links, findings })
}

/// Makes the window as wide and as high as this, in pixels.
fn resize(tab: &Tab, width: u32, height: u32) -> Result<()> {
    tab.call_method(Emulation::SetDeviceMetricsOverride {
        width,
        height,
        device_scale_factor: 1.0,
        mobile: false,
        scale: None,
        screen_width: None,
        screen_height: None,
        position_x: None,
        position_y: None,
        dont_set_visible_size: None,
        screen_orientation: None,
        viewport: None,
        display_feature: None,
        device_posture: None,
    })?;
    Ok(())
}

/// Collects errors of scripts, requests that leave the folder, and requests that fail.
fn listen(tab: &Tab, base: Url) -> Result<Arc<Mutex<Vec<String>>>> {
    let found = Arc::new(Mutex::new(Vec::new()));
    let collected = Arc::clone(&found);
    tab.add_event_listener(Arc::new(move |event: &Event| {
        if let Some(what) = finding(event, &base)
            && let Ok(mut collected) = collected.lock()
        {
            collected.push(what);
        }
    }))?;
    tab.enable_runtime()?;
    tab.call_method(Log::Enable(None))?;
    tab.call_method(Network::Enable {
        max_total_buffer_size: None,
        max_resource_buffer_size: None,
        max_post_data_size: None,
        report_direct_socket_traffic: None,
        enable_durable_messages: None,
    })?;
    Ok(found)
}

/// Returns what an event says is wrong.
fn finding(event: &Event, base: &Url) -> Option<String> {
    match event {
        Event::NetworkRequestWillBeSent(event) => {
            let url = &event.params.request.url;
            let inside = url.starts_with(base.as_str());
            let inside = inside || url.starts_with("data:") || url.starts_with("blob:");
            (!inside).then(|| format!("request to {url} leaves the folder"))
        }
        Event::NetworkLoadingFailed(event) => {
            let canceled = event.params.canceled.unwrap_or(false);
            (!canceled).then(|| format!("a request failed: {}", event.params.error_text))
        }
        Event::RuntimeExceptionThrown(event) => {
            let details = &event.params.exception_details;
            let exception = details.exception.as_ref().and_then(|it| it.description.clone());
            let text = exception.unwrap_or_else(|| details.text.clone());
            Some(format!("error of a script: {text}"))
        }
        Event::RuntimeConsoleAPICalled(event)
            if event.params.Type == Runtime::ConsoleAPICalledEventTypeOption::Error =>
        {
            let said = event.params.args.iter().filter_map(|it| it.value.as_ref());
            let said: Vec<String> =
                said.map(|it| it.as_str().map_or_else(|| it.to_string(), str::to_owned)).collect();
            Some(format!("console error: {}", said.join(" ")))
        }
        _ => None,
    }
}

/// Waits until the page is complete.
fn wait_for(tab: &Tab, url: &Url) -> Result<()> {
    let expected = format!("complete {url}");
    let start = Instant::now();
    while start.elapsed() < PATIENCE {
        // While the page changes there is no context to evaluate in.
        if text(tab, "document.readyState + ' ' + location.href").is_ok_and(|it| it == expected) {
            return Ok(());
        }
        thread::sleep(Duration::from_millis(10));
    }
    Err(Error::msg(format!("not complete after {} s", PATIENCE.as_secs())))
}

/// Evaluates an expression whose value, or promised value, is a text.
fn text(tab: &Tab, expression: &str) -> Result<String> {
    let value = tab.evaluate(expression, true)?;
    match value.value {
        Some(Value::String(text)) => Ok(text),
        _ => Err(Error::msg(value.description.unwrap_or_else(|| "no text".to_owned()))),
    }
}
