/** The user study's page. */
import { render } from "preact";
import { App } from "./app";
import { createStore } from "./store";
import { readStudy } from "./study";
import "./style.css";
import "./scene.css";
import { TEXTS, usualLanguage } from "./texts";

const study = readStudy();
const missing = <main class="missing">{TEXTS[usualLanguage()].missing}</main>;
const app = document.getElementById("app");
if (app) render(study ? <App store={createStore(study)} /> : missing, app);
