// planes.zvp from disk: dropped on the page, or chosen.
import {readContainer} from './container';
import type {Container} from './container';

export class FileIntake {
    private readonly input = document.createElement('input');

    constructor(private readonly take: (container: Container, name: string) => void,
                private readonly complain: (text: string) => void) {
        this.input.type = 'file';
        this.input.multiple = true;
        this.input.accept = '.zvp';
        this.input.hidden = true;
        this.input.addEventListener('change', () => {
            void this.read(this.input.files);
        });
        document.body.append(this.input);
        document.addEventListener('dragover', (event) => event.preventDefault());
        document.addEventListener('drop', (event) => {
            event.preventDefault();
            void this.read(event.dataTransfer?.files ?? null);
        });
    }

    ask(): void {
        this.input.value = '';
        this.input.click();
    }

    private async read(files: FileList | null): Promise<void> {
        for (const file of files ?? []) {
            try {
                this.take(readContainer(new Uint8Array(await file.arrayBuffer())), file.name);
            } catch (error) {
                this.complain(`${file.name}: ${error instanceof Error ? error.message : error}`);
            }
        }
    }
}
